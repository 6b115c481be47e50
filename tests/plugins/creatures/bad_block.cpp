// Written with the SDK: what goes wrong in a block comes back as a status with words, or as a number that is none.
#include <similitude/drag_law.h>

#include <limits>
#include <stdexcept>

namespace {
using namespace similitude;

struct Throws {
  template <class V>
  V exchange(const DragState<V>&) const {
    throw std::domain_error("this gas is too thin for me.\n  Use a thicker one.");
  }
};

struct ReturnsNan {
  template <class V>
  V exchange(const DragState<V>&) const {
    return V(std::numeric_limits<double>::quiet_NaN());
  }
};

}  // namespace

SIMILITUDE_PLUGIN(drag_law<Throws>({"throws_in_a_block", "1.0.0", "A creature of the zoo"}),
                  drag_law<ReturnsNan>({"returns_nan", "1.0.0", "A creature of the zoo"}))
