// docs/theory/paper-audit.md is written by this test, from the plugins and formulas that runs use:
//   SIMILITUDE_WRITE_DOCS=1 build/tests/scaling_verification --gtest_filter='PaperAudit.*'
// Without the variable it compares, so that the page cannot rot.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>

#include "../bed/small_bed.h"
#include "similarity/groups.h"
#include "similarity/sphere_drag.h"

namespace similitude::test {
namespace {

constexpr SphereInGas k_alumina{1e-3, 1040, 1.225, 1.79e-5, 9.81};
constexpr double k_printed_u_mf = 0.36;      // [m/s]
constexpr double k_quarter = 0.25;           // r
constexpr double k_particles = 461000;
const char* const k_page = SIMILITUDE_SOURCE "/docs/theory/paper-audit.md";

/// The ratios that the shipped case gives.
similitude_ratios ratios_of(const std::string& bed, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(SIMILITUDE_SOURCE) / "configs" / bed / (name + ".yaml");
  return assemble(read_case(file, built_plugins()).scene, built_plugins()).ratios;
}

SphereInGas scaled(const SphereInGas& s, const similitude_ratios& r) {
  return {s.diameter * r.drag_diameter, s.particle_density * r.particle_density, s.gas_density * r.gas_density,
          s.gas_viscosity * r.gas_viscosity, s.gravity};
}

// ---------------------------------------------------------------------------------------------------- printed numbers

enum class Verdict { reproduced, wrong };

struct PrintedNumber {
  const char* where;
  const char* quantity;
  double printed;
  double last_digit;   // the place of the last printed digit; rounding and cutting off both count as reproduced
  double computed;
  Verdict expected;    // what is known by hand: the test fails where the numbers say otherwise
  const char* remark;

  bool reproduced() const { return std::abs(computed - printed) < last_digit; }
};

std::vector<PrintedNumber> printed_numbers() {
  const similitude_ratios glicksman = ratios_of("spouted_bed", "glicksman"), link = ratios_of("spouted_bed", "link"),
                          ut = ratios_of("spouted_bed", "terminal_velocity"), glass = ratios_of("spouted_bed_glass", "glicksman");
  const double eps = gas_fraction_ergun(k_alumina, k_printed_u_mf);
  const double root = std::sqrt(k_quarter);
  const SphereInGas small = scaled(k_alumina, glicksman), light = scaled(k_alumina, link), dense = scaled(k_alumina, ut);
  const double u_t = terminal_velocity_newton(k_alumina);
  const auto over_terminal = [&](const SphereInGas& s, double velocity) { return velocity * u_t / terminal_velocity_newton(s); };
  const auto count = [](const similitude_ratios& r) { return k_particles * std::pow(r.length / r.diameter, 3); };
  return {
      {"Exact", "u_mf [m/s]", 0.36, 0.01, minimum_fluidisation_ergun(k_alumina, 0.4328), Verdict::reproduced,
       "by Ergun at a gas fraction of 0.4328, which is not stated; 0.40 gives 0.292, 0.42 gives 0.333"},
      {"Exact", "u_t by Eq. 18 [m/s]", 4.99, 0.01, u_t, Verdict::reproduced, "cut off, not rounded"},
      {"Glicksman", "n", 0.62, 0.01, glicksman.diameter, Verdict::reproduced, "by the correct Ergun balance, not by Eq. 14 as printed"},
      {"Glicksman", "n of glass", 0.62, 0.01, glass.diameter, Verdict::wrong, "0.62 is alumina's"},
      {"Glicksman", "u_mf [m/s]", 0.18, 0.01, minimum_fluidisation_ergun(small, eps), Verdict::reproduced, ""},
      {"Glicksman", "Re ratio", 0.310, 0.001, 0.62 * root, Verdict::reproduced, "n sqrt(r) with the printed n"},
      {"Glicksman", "Ar ratio", 0.239, 0.001, 0.62 * 0.62 * 0.62, Verdict::reproduced, "n^3 with the printed n; 0.239 to the last digit is that of 0.6206"},
      {"Glicksman", "u_t by Eq. 18 [m/s]", 2.88, 0.01, terminal_velocity_newton(small), Verdict::wrong,
       "2.88 is the exact case's without the factor 3 of Eq. 18"},
      {"Glicksman", "u0/u_t ratio", 0.711, 0.001, over_terminal(small, root), Verdict::wrong,
       "0.711 and 2.88 m/s contradict each other as well"},
      {"Glicksman", "u_sp [m/s]", 0.66, 0.01, 13.2 * root, Verdict::wrong, "a slip of a factor ten"},
      {"Link", "rho_p [kg/m^3]", 520.6, 0.1, light.particle_density, Verdict::reproduced, ""},
      {"Link", "mu [1e-5 Pa s]", 3.58, 0.01, 1e5 * light.gas_viscosity, Verdict::reproduced, ""},
      {"Link", "u_mf [m/s]", 0.36, 0.01, minimum_fluidisation_ergun(light, eps), Verdict::reproduced, ""},
      {"Link", "u_t by Eq. 18 [m/s]", 4.99, 0.01, terminal_velocity_newton(light), Verdict::reproduced,
       "the table itself: as in the exact case"},
      {"Link", "u0/u_t ratio", 0.707, 0.001, over_terminal(light, 1), Verdict::wrong,
       "Re and Ar are kept, hence u0/u_t under every drag law; 0.707 forgets the lighter particles. It is the reason given for the new law"},
      {"u_t law", "n", 0.708, 0.001, ut.diameter, Verdict::reproduced, ""},
      {"u_t law", "rho_f [kg/m^3]", 3.461, 0.001, dense.gas_density, Verdict::reproduced, ""},
      {"u_t law", "u_mf [m/s]", 0.18, 0.01, minimum_fluidisation_ergun(dense, eps), Verdict::reproduced, "at any gas fraction"},
      {"u_t law", "u_t by Eq. 18 [m/s]", 2.49, 0.01, terminal_velocity_newton(dense), Verdict::reproduced, "cut off, not rounded"},
      {"u_t law", "u_sp [m/s]", 6.6, 0.1, 13.2 * ut.velocity, Verdict::reproduced, ""},
      {"u_t law", "Re ratio", 1, 1e-3, reynolds(dense, ut.velocity) / reynolds(k_alumina, 1), Verdict::reproduced, ""},
      {"u_t law", "Ar ratio", 1, 1e-3, archimedes(dense) / archimedes(k_alumina), Verdict::reproduced,
       "with rho_f in Ar; 0.354 with Ar as printed"},
      {"u_t law", "u0/u_t ratio", 1, 1e-3, over_terminal(dense, root), Verdict::reproduced, ""},
      {"Parcel, Link", "particles", 51000, 1000, count(link), Verdict::wrong, "the text says (n/r)^3 fewer; what was filled is 11 % less"},
      {"Glicksman", "particles", 23000, 1000, count(glicksman), Verdict::wrong, "24 % less; the beds compared differ in mass"},
      {"u_t law", "particles", 17000, 1000, count(ut), Verdict::wrong, "16 % less"},
      {"Text", "Re and Ar ratio of tiny particles by Glicksman, r = 1/4", 0.34, 0.01, std::pow(k_quarter, 0.75), Verdict::wrong, "n = r^(1/4), so Re* = n sqrt(r) = Ar* = n^3 = r^(3/4)"},
      {"Text", "the same, r = 1/16", 0.12, 0.01, std::pow(1.0 / 16, 0.75), Verdict::reproduced, "0.125, cut off"},
  };
}

/// With the printed number of decimals, and some more.
std::string number(double value, double last_digit, int more) {
  if (value >= 10000) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, static_cast<int>(std::lround(-std::log10(last_digit))) + more);
}

// ----------------------------------------------------------------------------------------------------------- equations

/// n of Eq. 14 with its terms as printed: 1 - eps in the second, (1 - eps)^2 in the third, and sqrt(r) u^2.
double eq_14_as_printed(const SphereInGas& s, double eps, double velocity_square_ratio) {
  const double u = minimum_fluidisation_ergun(s, eps), cube = eps * eps * eps, d = s.diameter;
  const double a = s.gravity * (s.particle_density - s.gas_density);
  const double b = 1.75 * s.gas_density * velocity_square_ratio * u * u * (1 - eps) / (d * cube);
  const double c = 150 * s.gas_viscosity * (1 - eps) * (1 - eps) * std::sqrt(k_quarter) * u / (d * d * cube);
  return (b + std::sqrt(b * b + 4 * a * c)) / (2 * a);
}

/// u_mf without the pressure-gradient force: Ergun's drag alone carries the weight, which takes 1/eps times as much.
double u_mf_of_drag_alone(const SphereInGas& s, double eps) {
  // phi (rho_p - rho_f) g = (150 phi^2 mu U + 1.75 phi rho U^2 d) / (d^2 eps^2): eps^2 in place of eps^3.
  const double viscous = k_ergun_viscous * (1 - eps), driving = eps * eps * archimedes(s);
  const double re = 2 * driving / (viscous + std::sqrt(viscous * viscous + 4 * k_ergun_inertial * driving));
  return re * s.gas_viscosity / (s.gas_density * s.diameter);
}

/// v_r^2 / eps of Syamlal-O'Brien: what Eq. 5 with C_D of Eq. 7 as printed multiplies the drag by.
double drag_as_printed(double eps, double re) {
  const double a = std::pow(eps, 4.14), b = 0.8 * std::pow(eps, 1.28), s = 0.06 * re;
  const double v_r = 0.5 * (a - s + std::sqrt(s * s + 2 * s * (2 * b - a) + a * a));
  return v_r * v_r / eps;
}

DragModel syamlal_obrien() {
  const CaseFile file = read_case(std::filesystem::path(SIMILITUDE_SOURCE) / "configs/spouted_bed/exact.yaml", built_plugins());
  const PluginEntry& entry = *built_plugins().find("drag", "syamlal_obrien");
  std::vector<similitude_value> values;
  for (const ModelParameter& parameter : file.scene.models.drag.parameters) values.push_back({parameter.real, nullptr});
  return create_model<similitude_drag_functions>(entry, describe(file.scene), values);
}

std::string equations() {
  const double eps = gas_fraction_ergun(k_alumina, k_printed_u_mf);
  const similitude_ratios glicksman = ratios_of("spouted_bed", "glicksman"), ut = ratios_of("spouted_bed", "terminal_velocity");
  const DragModel law = syamlal_obrien();
  const SphereInGas small = scaled(k_alumina, glicksman);
  const double real_mf = minimum_fluidisation(k_alumina, sphere_drag(law, k_alumina, 1), eps);
  const double small_mf = minimum_fluidisation(small, sphere_drag(law, small, 1), eps);
  const double re_mf = reynolds(k_alumina, k_printed_u_mf / 0.42);
  const double ut_alone = terminal_velocity(k_alumina, dalla_valle), ut_schiller = terminal_velocity(k_alumina, schiller_naumann);
  std::string text = "| equation | finding |\n|---|---|\n";
  const auto row = [&](const std::string& equation, const std::string& finding) { text += "| " + equation + " | " + finding + " |\n"; };
  row("1, 6, 8, 11, 15", "No error is known.");
  row("2, 3", "With - div(tau) the stress is tau = - mu (...), not + mu (...). Model A wants eps div(tau), and the term left out with the bulk "
              "viscosity vanishes only where the gas fraction is constant in time.");
  row("4", fmt::format("The pressure-gradient force must not be left out: it carries the share phi of the load, and without it momentum is not "
                       "conserved. u_mf by Ergun rises from {:.3f} to {:.3f} m/s, so a background of 0.46 m/s fluidizes nothing. The "
                       "buoyancy is g (rho_p - rho_f)/rho_p with g the vector.",
                       minimum_fluidisation_ergun(k_alumina, eps), u_mf_of_drag_alone(k_alumina, eps)));
  row("5, 7", fmt::format("C_D of Eq. 7 wants eps/v_r^2 beside it. As printed the drag at a gas fraction of 0.42 and Re = {:.1f} is multiplied by "
                          "{:.3f}.",
                          re_mf, drag_as_printed(0.42, re_mf)));
  row("9", "The unit vector is the line of centres, not the direction of the relative velocity; the damping acts along it.");
  row("10", "Friction falling with the sliding speed: right; its v_glide is a speed and must scale with sqrt(r). At the same v_glide the "
            "quarter beds have another friction.");
  row("12", "u_ex/u_sc = r^(-1/2) with r = L_sc/L_ex; the text uses u_sc = sqrt(r) u_ex, which is right.");
  row("13", fmt::format("Ergun: right. 0.36 m/s needs a gas fraction of {:.4f}, which is not stated.", eps));
  row("14", fmt::format("1 - eps too much in the second term, (1 - eps)^2 for 1 - eps in the third, sqrt(r) u^2 for r u^2. As printed n = {:.3f} "
                        "({:.3f} with r u^2); correct n = {:.4f}. And u_mf shrinks as meant under Ergun alone: under Syamlal-O'Brien, which "
                        "the runs used, u0/u_mf is {:.3f} of the exact bed's.",
                        eq_14_as_printed(k_alumina, eps, std::sqrt(k_quarter)), eq_14_as_printed(k_alumina, eps, k_quarter),
                        glicksman.diameter, std::sqrt(k_quarter) * real_mf / small_mf));
  row("16", fmt::format("rho_f is missing in Ar, which then has a unit and a ratio of {:.3f}; subscripts z, 1 and 2 stand where sc, ex and sc are meant.",
                        1 / ut.gas_density));
  row("17, 19", "Right: they are the member of the similarity family with particle density and viscosity kept.");
  row("18", fmt::format("Newton's regime with C_D = 4/9 needs Re above 750; here it is {:.0f} to {:.0f}. {:.2f} m/s is {:.0f} to {:.0f} % above the "
                        "{:.2f} to {:.2f} m/s of real drag laws. Harmless for the scaling: Re_t is a function of Ar.",
                        reynolds(k_alumina, ut_alone), reynolds(k_alumina, terminal_velocity_newton(k_alumina)),
                        terminal_velocity_newton(k_alumina), 100 * (terminal_velocity_newton(k_alumina) / ut_schiller - 1),
                        100 * (terminal_velocity_newton(k_alumina) / ut_alone - 1), ut_alone, ut_schiller));
  return text;
}

// ---------------------------------------------------------------------------------------------------------------- page

std::string claims() {
  const similitude_ratios ut = ratios_of("spouted_bed", "terminal_velocity");
  const SphereInGas light = scaled(k_alumina, ratios_of("spouted_bed", "link"));
  const double coarser = ut.diameter / ut.length;
  std::string text;
  const auto item = [&](const std::string& words) { text += "* " + words + "\n"; };
  item(fmt::format("*u0/u_t is lost by Link's law and kept by the new one*: both keep it under every drag law. For Link's law the ratio is {:.6f} by "
                   "Eq. 18, {:.6f} by Schiller-Naumann, {:.6f} by Dalla Valle. They are members of one family (scaling.md) and keep the same groups.",
                   terminal_velocity_newton(k_alumina) / terminal_velocity_newton(light),
                   terminal_velocity(k_alumina, schiller_naumann) / terminal_velocity(light, schiller_naumann),
                   terminal_velocity(k_alumina, dalla_valle) / terminal_velocity(light, dalla_valle)));
  item(fmt::format("*The new law retains all groups*: not the density ratio ({:.0f} becomes {:.0f}), not L/d (x {:.3f}), not the jet's momentum over "
                   "the bed's weight (x {:.2f}; Link's law x 2).",
                   k_alumina.particle_density / k_alumina.gas_density,
                   k_alumina.particle_density / (k_alumina.gas_density * ut.gas_density), 1 / coarser, coarser));
  item(fmt::format("*The gas density rises only slightly more than Link's particle density falls*: x {:.2f} against / 2.", ut.gas_density));
  item(fmt::format("*Up to 95 % fewer particles*: {:.1f} % by (n/r)^3, 96.3 % as printed for the u_t law; 95.0 % is Glicksman's.",
                   100 * (1 - 1 / (coarser * coarser * coarser))));
  item("*A quarter of the time step for the quarter beds*: sound. 2e-5 s belongs to spheres of 2 mm, and the contact time goes with the square "
       "root of the mass. (\"2e 5\" has lost its sign.)");
  item("*Entrance 0.3 m below the plates*: the bed is 0.145 m deep; 0.03 m must be meant. Of the two pairs of heights given for profiles only "
       "10 and 30 cm lie in the bed and in its fountain.");
  return text;
}

std::string page() {
  std::string text =
      "# The paper, recomputed\n\n"
      "**The paper** is the one in which S. Banerjee and R. K. Agarwal propose the terminal-velocity law, for Sutkar et al.'s spouted bed with draft "
      "plates and grains of gamma-alumina. Its journal, year and doi are not known here: what could be found is its forerunner with glass "
      "beads, which is another paper (Banerjee, S. & Agarwal, R. K. (2016), Characterization of Scaling Laws in Computational Fluid Dynamics "
      "Simulations of Spouted Fluidized Beds for Chemical Looping Combustion, Energy & Fuels, doi 10.1021/acs.energyfuels.6b00855). Numbers of tables "
      "and equations below are those of the alumina paper.\n\n"
      "The paper that proposed the terminal-velocity law compares four ways to simulate a spouted bed of 461 000 grains of alumina. Each number "
      "of its Table 1 and each of its equations was recomputed with the formulas and plugins of this program. Numbers that a run cannot "
      "reproduce are given with the right value. This page is written by tests/verification/scaling/paper_audit_test.cpp, which "
      "fails when the page and the program differ.\n\n"
      "Alumina: d = 1 mm, rho_p = 1040 kg/m^3; gas: rho_f = 1.225 kg/m^3, mu = 1.79e-5 Pa s; g = 9.81 m/s^2; r = 1/4, n = 2 for parcels and Link.\n\n"
      "## Table 1\n\n"
      "| case | quantity | printed | recomputed | | remark |\n|---|---|---:|---:|---|---|\n";
  for (const PrintedNumber& n : printed_numbers()) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", n.where, n.quantity, number(n.printed, n.last_digit, 0), number(n.computed, n.last_digit, 1),
                        n.reproduced() ? "reproduced" : "**wrong**", n.remark);
  }
  text += "\n## Equations\n\n" + equations() + "\n## Claims of the text\n\n" + claims();
  return text;
}

}  // namespace

TEST(PaperAudit, EveryPrintedNumberIsWhatIsKnownOfIt) {
  for (const PrintedNumber& n : printed_numbers())
    EXPECT_EQ(n.reproduced(), n.expected == Verdict::reproduced) << n.where << " " << n.quantity << ": " << n.computed;
}

// The right values of what is printed wrong, recomputed by an independent script.
TEST(PaperAudit, GivesTheRightValues) {
  const auto value = [](const std::string& where, const std::string& quantity) {
    for (const PrintedNumber& n : printed_numbers())
      if (where == n.where && quantity == n.quantity) return n.computed;
    ADD_FAILURE() << where << " " << quantity;
    return 0.0;
  };
  EXPECT_NEAR(value("Exact", "u_t by Eq. 18 [m/s]"), 4.9956, 5e-5);
  EXPECT_NEAR(value("u_t law", "u_t by Eq. 18 [m/s]"), 2.4978, 5e-5);
  EXPECT_NEAR(value("Glicksman", "u_t by Eq. 18 [m/s]"), 3.932, 5e-4);
  EXPECT_NEAR(value("Glicksman", "u0/u_t ratio"), 0.6352, 5e-5);
  EXPECT_NEAR(value("Glicksman", "u_sp [m/s]"), 6.6, 1e-12);
  EXPECT_NEAR(value("Glicksman", "n of glass"), 0.5714, 5e-5);
  EXPECT_NEAR(value("Link", "u0/u_t ratio"), 1, 1e-12);
  EXPECT_NEAR(value("Parcel, Link", "particles"), 57625, 0.5);
  EXPECT_NEAR(value("Glicksman", "particles"), 30278, 0.5);
  EXPECT_NEAR(value("u_t law", "particles"), 20308, 0.5);
  const double eps = gas_fraction_ergun(k_alumina, k_printed_u_mf);
  EXPECT_NEAR(eq_14_as_printed(k_alumina, eps, std::sqrt(k_quarter)), 0.4842, 5e-5);
  EXPECT_NEAR(eq_14_as_printed(k_alumina, eps, k_quarter), 0.4583, 5e-5);
  EXPECT_NEAR(u_mf_of_drag_alone(k_alumina, eps), 0.653, 5e-4);
  EXPECT_NEAR(drag_as_printed(0.42, reynolds(k_alumina, k_printed_u_mf / 0.42)), 0.146, 5e-4);
}

TEST(PaperAudit, IsThePageInTheDocumentation) {
  const std::string now = page();
  if (std::getenv("SIMILITUDE_WRITE_DOCS") != nullptr) std::ofstream(k_page) << now;
  std::ifstream file(k_page);
  std::stringstream written;
  written << file.rdbuf();
  EXPECT_EQ(written.str(), now) << "Write the page again: the first lines of paper_audit_test.cpp say how.";
}

}  // namespace similitude::test
