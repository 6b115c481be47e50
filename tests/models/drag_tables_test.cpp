// Every drag law against the table of beta/phi [kg/(m^3 s)] for d = 1 mm, rho_f = 1.225, mu = 1.79e-5 at the nine states of
// k_states, printed to five digits and rebuilt from the public codes' formulas; and against minimum fluidization velocities.
#include <gtest/gtest.h>

#include <string>

#include "drag_model.h"

namespace similitude {
namespace {

using namespace test;

struct Tabled {
  const char* name;
  const char* file;
  Values parameters;
  double beta_over_phi[std::size(k_states)];
};

class DragTable : public testing::TestWithParam<Tabled> {};

TEST_P(DragTable, IsMet) {
  const DragModel law(GetParam().file, {GetParam().parameters});
  for (std::size_t s = 0; s < std::size(k_states); ++s) {
    const double tabled = GetParam().beta_over_phi[s];
    EXPECT_NEAR(exchange(law, k_states[s].gas_fraction, k_states[s].slip) / k_volume, tabled, 1e-4 * tabled)
        << "eps " << k_states[s].gas_fraction;
  }
}

const Tabled k_table[] = {
    {"SyamlalOBrien", SYAMLAL_OBRIEN, {}, {5510.9, 4272.8, 3563.3, 3798.1, 3797.4, 3504.2, 3732.9, 3226.2, 2842.2}},
    {"WenYu", WEN_YU, {}, {8976.8, 6298, 3649.3, 2780.4, 2779.6, 2447.3, 2730.9, 2660.3, 2405.9}},
    {"Ergun", ERGUN, {}, {6171.2, 4996.7, 3933.8, 4958.8, 4958.3, 4761.3, 6729.6, 8602.1, 7503.1}},
    {"Gidaspow", GIDASPOW, {}, {6171.2, 4996.7, 3933.8, 4958.8, 2779.6, 2447.3, 2730.9, 2660.3, 2405.9}},
    {"HuilinGidaspow", HUILIN_GIDASPOW, {}, {6179.8, 5001.2, 3932, 3869.6, 3850.8, 2503.4, 2779.4, 2698.2, 2436.8}},
    {"DiFelice", DI_FELICE, {}, {5764.5, 4348.8, 2993.9, 2807.6, 2807.1, 2558.3, 3027.9, 3161.6, 2842.2}},
    {"DiFeliceAsInMfix", DI_FELICE, {{"drag_coefficient", "schiller_naumann"}},
     {5186.4, 3912.5, 2691.7, 2480.2, 2479.7, 2254.9, 2608.7, 2650.4, 2405.9}},
    {"Rong", RONG, {}, {5957.5, 4485.7, 3057.6, 2967.8, 2967.2, 2697, 3198.9, 3188.1, 2842.2}},
    {"KochHill", KOCH_HILL, {}, {6568.9, 5096.3, 3220.7, 3113.4, 3113, 2953.1, 3818, 4415.1, 3814.4}},
    {"Beetstra", BEETSTRA, {}, {6707.7, 5382.9, 3878.5, 3525.2, 3524.5, 3168.2, 3717, 3647.1, 3169.9}},
    {"Tang", TANG, {}, {7550.5, 5897.4, 3821.4, 3160.6, 3160, 2872.1, 3218.6, 3043.2, 2721.1}},
    {"Tenneti", TENNETI, {}, {6143.2, 4988.4, 3458.1, 2706.3, 2705.6, 2402.9, 2637.6, 2669.5, 2405.9}},
};
INSTANTIATE_TEST_SUITE_P(AllLaws, DragTable, testing::ValuesIn(k_table),
                         [](const auto& info) { return std::string(info.param.name); });

// C_D(Re, sphericity) of the single particle, five digits; with an empty gas around it hindrance makes no difference.
TEST(DragHaiderLevenspiel, HasTheTabledCoefficient) {
  struct Row {
    double reynolds, sphericity, coefficient;
  };
  const Row table[] = {{1, 1, 28.47},       {1, 0.8, 30.739},     {1, 0.6, 36.37},
                       {100, 1, 1.1498},    {100, 0.8, 1.3017},   {100, 0.6, 2.3498},
                       {1000, 1, 0.48386},  {1000, 0.8, 1.2549},  {1000, 0.6, 2.6534}};
  for (const char* hindrance : {"none", "wen_yu"}) {
    for (const Row& row : table) {
      const DragModel law(HAIDER_LEVENSPIEL, {Values{{"sphericity", row.sphericity}, {"hindrance", hindrance}}});
      EXPECT_NEAR(24 / row.reynolds * factor(law, 1, row.reynolds), row.coefficient, 1e-4 * row.coefficient)
          << row.reynolds << ' ' << row.sphericity << ' ' << hindrance;
    }
  }
}

// Closed form: beta u_s = eps phi (rho_p - rho_f) g, u_mf = eps u_s. Printed to 1e-4 m/s.
TEST(MinimumFluidization, OfAluminaIsErgunsSyamlalOBriensAndBeetstras) {
  const auto u_mf = [](const DragModel& law, double eps) { return carrying_slip(law, eps, alumina_bed()) * eps; };
  const DragModel ergun(ERGUN, {Values{}}), gidaspow(GIDASPOW, {Values{}}), syamlal(SYAMLAL_OBRIEN, {Values{}});
  const double table[][3] = {{0.40, 0.2916, 0.3311}, {0.42, 0.3326, 0.3704}, {0.44, 0.3759, 0.4123}, {0.46, 0.4215, 0.4568}};
  for (const auto& row : table) {
    EXPECT_NEAR(u_mf(ergun, row[0]), row[1], 6e-5);
    EXPECT_NEAR(u_mf(gidaspow, row[0]), row[1], 6e-5);
    EXPECT_NEAR(u_mf(syamlal, row[0]), row[2], 6e-5);
  }
  EXPECT_NEAR(u_mf(ergun, 0.4328), 0.3600, 6e-5);
  EXPECT_NEAR(u_mf(syamlal, 0.4328), 0.3969, 6e-5);
  EXPECT_NEAR(u_mf(DragModel(BEETSTRA, {Values{}}), 0.4328), 0.3389, 6e-5);
}

}  // namespace
}  // namespace similitude
