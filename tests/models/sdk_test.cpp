// What the SDK makes of an author's type.
#include <gtest/gtest.h>
#include <similitude/layout.h>

#include <fstream>
#include <iterator>

#include "sphere_on_wall.h"

namespace similitude {
namespace {

using test::open_plugin;
using test::Values;
using ScalingModel = test::TestModel<similitude_scaling_functions>;
using DragModel = test::TestModel<similitude_drag_functions>;
using EffectModel = test::TestModel<similitude_effect_functions>;

const similitude_descriptor& sample(const std::string& id) {
  const similitude_entry& entry = open_plugin(SEVERAL);
  for (std::uint32_t d = 0; d < entry.descriptor_count; ++d) {
    if (entry.descriptors[d]->id == id) return *entry.descriptors[d];
  }
  throw std::runtime_error("no sample " + id);
}

similitude_ratios ratios(const ScalingModel& law, similitude_status& status) {
  similitude_ratios r{};
  r.struct_size = sizeof r;
  const similitude_bed bed = test::alumina_bed();
  law.functions().ratios(law.instance(), &bed, &r, &status);
  return r;
}

TEST(Plugin, IsListedWithoutCreatingAnything) {
  const similitude_entry& entry = open_plugin(SEVERAL);
  ASSERT_EQ(entry.descriptor_count, 7u);
  EXPECT_EQ(entry.struct_size, sizeof entry);
  const similitude_descriptor& first = *entry.descriptors[0];
  EXPECT_STREQ(first.kind, "scaling");
  EXPECT_STREQ(first.id, "catalogued");
  EXPECT_STREQ(first.version, "1.2.3");
  EXPECT_STREQ(first.title, "All kinds of parameters");
  EXPECT_STREQ(first.authors, "somebody");
  EXPECT_STREQ(first.reference, "somewhere");
  EXPECT_EQ(entry.descriptors[1]->reference, nullptr);
}

TEST(Plugin, HasItsTagAsPlainBytesInTheFile) {
  for (const char* file : {SEVERAL, BOUNCY, LINEAR_SPRING}) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    const similitude_tag& mapped = *open_plugin(file).tag;
    EXPECT_NE(bytes.find(std::string(reinterpret_cast<const char*>(&mapped), sizeof mapped)), std::string::npos) << file;
    EXPECT_STREQ(mapped.magic, SIMILITUDE_TAG_MAGIC);
    EXPECT_EQ(mapped.struct_size, sizeof mapped);
    EXPECT_EQ(mapped.abi_major, SIMILITUDE_ABI_MAJOR);
    EXPECT_EQ(mapped.abi_minor, SIMILITUDE_ABI_MINOR);
    EXPECT_EQ(mapped.layout_hash, abi::layout_hash());
    EXPECT_NE(std::string(mapped.instruction_set), "");
    EXPECT_NE(std::string(mapped.compiler), "");
  }
}

TEST(Parameters, AreTheTableTheAuthorDeclared) {
  const similitude_descriptor& d = sample("catalogued");
  ASSERT_EQ(d.parameter_count, 7u);
  const similitude_parameter* p = d.parameters;
  EXPECT_STREQ(p[0].name, "length");
  EXPECT_STREQ(p[0].unit, "m");
  EXPECT_STREQ(p[0].doc, "a length");
  EXPECT_EQ(p[0].required, 1);
  EXPECT_EQ(p[0].scales_as, SIMILITUDE_SCALES_AS_DIAMETER);
  EXPECT_TRUE(std::isinf(p[0].maximum));
  EXPECT_EQ(p[1].required, 0);
  EXPECT_EQ(p[1].default_value, 2);
  EXPECT_EQ(p[1].minimum, 1);
  EXPECT_EQ(p[1].maximum, 3);
  EXPECT_EQ(p[1].typical_minimum, 1.5);
  EXPECT_EQ(p[1].typical_maximum, 2.5);
  EXPECT_EQ(p[1].scales_as, SIMILITUDE_SCALES_AS_VELOCITY);
  EXPECT_EQ(p[2].scales_as, SIMILITUDE_SCALES_NOT);
  EXPECT_EQ(p[3].required, 0);
  EXPECT_TRUE(std::isnan(p[3].default_value));
  EXPECT_EQ(p[3].scales_as, SIMILITUDE_SCALES_AS_MODULUS);
  EXPECT_EQ(p[4].type, SIMILITUDE_INTEGER);
  EXPECT_EQ(p[4].default_value, 3);
  EXPECT_EQ(p[5].type, SIMILITUDE_FLAG);
  EXPECT_EQ(p[5].default_value, 1);
  EXPECT_EQ(p[6].type, SIMILITUDE_CHOICE);
  EXPECT_STREQ(p[6].choices, "round|square");
  EXPECT_STREQ(p[6].default_text, "square");
}

TEST(Parameters, ArriveInTheAuthorsMembers) {
  similitude_status status{};
  const similitude_ratios r = ratios(ScalingModel(sample("catalogued"), {{{"length", 0.25}, {"count", 5}, {"on", 0}}}), status);
  EXPECT_EQ(status.code, 0);
  EXPECT_EQ(r.length, 0.25);
  EXPECT_EQ(r.diameter, 2);
  EXPECT_EQ(r.drag_diameter, 0.5);
  EXPECT_EQ(r.particle_density, -1);   // was not given
  EXPECT_EQ(r.gas_density, 5);
  EXPECT_EQ(r.gas_viscosity, 0);
  EXPECT_EQ(r.velocity, 1);            // the second choice
  EXPECT_EQ(r.time, 9.81);
}

std::string refusal(const std::string& id) {
  try {
    const ScalingModel law(sample(id), {Values{}});
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

TEST(Parameters, RefuseAMetreThatSaysNotHowItScales) {
  EXPECT_EQ(refusal("forgetful"),
            "parameter gap is in m, and nothing says how it scales with the bed.\n"
            "  Add .scales_as = similitude::Scales::as_length, as_diameter or another to its declaration.");
}

TEST(Plugin, TurnsExceptionsIntoWords) {
  EXPECT_EQ(refusal("throws_an_integer"), "the model threw something that is not a std::exception.");
  similitude_status status{};
  ratios(ScalingModel(sample("throws"), {Values{}}), status);
  EXPECT_EQ(status.code, 1);
  EXPECT_STREQ(status.text, "no ratios today");
}

TEST(Plugin, ReadsABedOfAnOlderHostAsFarAsItGoes) {
  similitude_bed bed = test::alumina_bed();
  bed.struct_size = offsetof(similitude_bed, gravity);
  const ScalingModel law(sample("catalogued"), {{{"length", 1}}});
  similitude_ratios r{};
  r.struct_size = sizeof r;
  similitude_status status{};
  law.functions().ratios(law.instance(), &bed, &r, &status);
  EXPECT_EQ(r.time, 0);
}

TEST(Plugin, WritesNoFurtherThanAnOlderHostsStructure) {
  const ScalingModel law(sample("catalogued"), {{{"length", 0.25}}});
  const similitude_bed bed = test::alumina_bed();
  similitude_ratios r{};
  r.struct_size = offsetof(similitude_ratios, diameter);
  r.diameter = 77;
  similitude_status status{};
  law.functions().ratios(law.instance(), &bed, &r, &status);
  EXPECT_EQ(r.length, 0.25);
  EXPECT_EQ(r.diameter, 77);
}

TEST(DragLaw, GetsTheColumnsItAsksFor) {
  const DragModel law(sample("curious"), {Values{}});
  similitude_drag_needs needs = {sizeof needs, 0, 0};
  law.functions().needs(law.instance(), &needs);
  EXPECT_EQ(needs.sauter_diameter, 1);
  EXPECT_EQ(needs.cell_size, 1);
  test::Column some(8, 1), sauter(8, 2), cell(8, 3), k(8);
  const similitude_drag_block block = {sizeof block, 8,           some.data(),   some.data(), some.data(), some.data(),
                                       some.data(),  sauter.data(), cell.data(), k.data()};
  similitude_status status{};
  law.functions().exchange(law.instance(), &block, &status);
  for (std::size_t row = 0; row < 8; ++row) EXPECT_EQ(k[row], 32);
}

TEST(ContactLaw, MayHaveACoupleAndAReach) {
  const test::ContactModel law(sample("rolls"), {Values{}});
  const similitude_contact_needs needs = test::needs_of(law);
  EXPECT_EQ(needs.couple, 1);
  EXPECT_EQ(needs.rotation, 1);
  EXPECT_EQ(needs.history_count, 0u);
  EXPECT_EQ(law.functions().reach(law.instance(), 1e-3), 1e-4);
  test::ContactColumns c(8);
  for (std::size_t row = 0; row < 8; ++row) {
    c.normal.set(row, {1, 0, 0});
    c.overlap[row] = 1e-5;
    c.angular_i.set(row, {0, 5, 0});
    c.angular_j.set(row, {0, 2, 0});
  }
  similitude_contact_block block = c.block(1e-6, 0);
  similitude_status status{};
  law.functions().forces(law.instance(), &block, &status);
  EXPECT_DOUBLE_EQ(c.force.get(3).x, 0.01);
  EXPECT_DOUBLE_EQ(c.couple.get(3).y, -3e-9);
}

// The law of the SDK's README. It says nothing about contact time, memory or spin.
TEST(Bouncy, IsWholeInAScreen) {
  const double e = 0.8, stiffness = 500;
  const test::ContactModel law(BOUNCY, {{{"stiffness", stiffness}, {"restitution", e}}});
  const similitude_contact_needs needs = test::needs_of(law);
  EXPECT_EQ(needs.history_count, 0u);
  EXPECT_EQ(needs.rotation, 0);
  EXPECT_EQ(needs.couple, 0);
  EXPECT_EQ(law.functions().reach(law.instance(), 1e-3), 0);
  const test::Sphere sphere{5e-4, 1040};
  const double time = law.functions().contact_time(law.instance(), 0, sphere.mass(), sphere.radius, 1.0);
  const double loss = std::log(e);
  EXPECT_NEAR(time, std::sqrt(sphere.mass() / stiffness * (9.8696044 + loss * loss)), 0.003 * time);
  for (const test::Rebound& r : impacts(law, sphere, {-1, 0, 0}, time / 100, test::all_phases(8))) {
    EXPECT_NEAR(r.velocity.x, e, 0.02 * e);
  }
}

TEST(Effect, AddsToWhatIsThere) {
  const EffectModel model(sample("pushes"), {Values{}});
  test::Column d(8, 1e-3), mass(8, 2), eps(8, 1), rho(8, 1), mu(8, 1), zero(8), fx(8, 5), fy(8, 6), fz(8, 7), c(8, 8);
  similitude_particle_block block{};
  block.struct_size = sizeof block;
  block.rows = 8;
  block.diameter = d.data();
  block.mass = mass.data();
  for (int a = 0; a < 3; ++a) block.velocity[a] = block.gas_velocity[a] = zero.data();
  block.gas_fraction = eps.data();
  block.gas_density = rho.data();
  block.gas_viscosity = mu.data();
  block.force[0] = fx.data(), block.force[1] = fy.data(), block.force[2] = fz.data();
  block.linear_coefficient = c.data();
  similitude_status status{};
  model.functions().particles(model.instance(), &block, &status);
  EXPECT_EQ(fx[7], 6);
  EXPECT_EQ(fy[7], 6);
  EXPECT_EQ(fz[7], 7);
  EXPECT_EQ(c[7], 8.001);
}

TEST(Effect, JudgesTheBed) {
  const EffectModel model(sample("pushes"), {Values{}});
  similitude_relevance relevance{};
  relevance.struct_size = sizeof relevance;
  const similitude_bed bed = test::alumina_bed();
  const similitude_evidence evidence{.struct_size = sizeof evidence, .reserved = 0, .bed = &bed, .value = nullptr,
                                     .inflow_value = nullptr, .occurred = nullptr};
  model.functions().relevance(model.instance(), &evidence, &relevance);
  EXPECT_EQ(relevance.verdict, 0);
  EXPECT_DOUBLE_EQ(relevance.value, 1.225 / 1040);
  EXPECT_DOUBLE_EQ(relevance.highest, relevance.value);
  EXPECT_STREQ(relevance.group, "rho_f/rho_p");
}

}  // namespace
}  // namespace similitude
