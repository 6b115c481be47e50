#include <gtest/gtest.h>

#include "loader/catalogue.h"
#include "loader/describe.h"

namespace similitude {
namespace {

// A built-in model is a plugin like a stranger's, and passes the same checks.
TEST(ShippedPlugins, AreAllTaken) {
  const Catalogue shipped(std::vector<SearchLevel>{search_levels({}).back()});
  EXPECT_EQ(failures_text(shipped), "No file was refused.\n");
}

}  // namespace
}  // namespace similitude
