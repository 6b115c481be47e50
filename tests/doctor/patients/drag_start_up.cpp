// Falls over before anybody asks it anything: its start-up code follows a null pointer.
#include <similitude/drag_law.h>

namespace {
using namespace similitude;

struct Innocent {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s);
  }
};

__attribute__((constructor, no_sanitize("undefined"))) void fall_over() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}

}  // namespace

SIMILITUDE_DRAG_LAW(Innocent, "innocent", "1.0.0", "Never gets to show what it can")
