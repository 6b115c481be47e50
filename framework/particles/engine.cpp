#include "particles/engine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include <omp.h>

#include <similitude/sphere.h>

#include "loader/contact_answers.h"
#include "particles/bricks.h"
#include "particles/carried_history.h"
#include "particles/contact_effects.h"
#include "particles/contact_lists.h"
#include "particles/contact_pass.h"
#include "particles/errors.h"
#include "particles/integrate.h"
#include "particles/stage_clock.h"
#include "particles/surfaces.h"

namespace similitude {

namespace {

// The skin in largest diameters, where the case gives none. A thick skin costs a look at more candidates in every
// sub-step, a thin one more rebuilds: the sum is least at sqrt(price x displacement per sub-step in diameters). The price
// was measured: a rebuild costs as much per particle as looking at some 75 candidates, and a diameter more of skin adds
// about ten candidates. All in numbers without a dimension and in counted steps, never in measured time.
constexpr double k_least_skin = 0.1, k_most_skin = 0.3;
constexpr double k_rebuild_price = 7.5;
constexpr double k_worth_a_change = 1.2;

/// What a brick reports of a sub-step; a cache line of its own.
struct alignas(64) BrickOutcome {
  MotionResult motion;
  Row wall_force;                  // [N], on all its particles
  std::size_t contacts = 0;
  DeepestContact deepest;          // since advance() began, or since the last rebuild in it
  bool left = false;
  std::int64_t pushed_in = -1;     // sub-step in which its pairs were last pushed; shared by threads
};

/// The bricks that a thread begins with; others take from it when theirs are done.
struct alignas(64) ThreadShare {
  std::uint32_t next = 0, end = 0;
};

std::string at_place(double x, double y, double z) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g) m", x, y, z);
  return text.data();
}

double wrapped(double position, double period) {
  const double inside = position - period * std::floor(position / period);
  return inside < period ? inside : 0;   // rounding may lift a small negative number to the period itself
}

}  // namespace

struct Engine::Parts {
  Parts(ParticleStore& store, const ModelScene& scene, const ContactModel& model, const EngineOptions& wanted,
        std::span<const EffectModel> all_effects)
      : particles(store),
        law(model),
        options(wanted),
        size(scene.size),
        periodic(scene.periodic),
        surfaces(scene),
        needs(needs_of(model)),
        effects(needs, all_effects),
        lists(effects.memory().rows(), scene.periodic[0] || scene.periodic[1] || scene.periodic[2]),
        carried(effects.memory()),
        contacts(store, model, effects, scene.particles.size(), surfaces, bricks, lists) {
    needs.rotation = needs.rotation || effects.rotation();
    if (!scene.models.contact_pairs.empty() && model.sets() != scene.models.contact_pairs.size()) {
      throw std::invalid_argument("the scene has contact parameters for each pair of materials, the law was made without them");
    }
  }

  static similitude_contact_needs needs_of(const ContactModel& model) {
    similitude_contact_needs needs{};
    needs.struct_size = sizeof(needs);
    model.functions().needs(model.instance(), &needs);
    return needs;
  }

  void advance(std::int64_t sub_steps);
  void sub_step();
  void rebuild();
  void build_lists(std::size_t rows);
  void save(EngineState& state) const;
  void restore(const EngineState& state);
  void sort_as_before();
  void wrap_positions();
  void mark_leaving();
  void carry_out(std::size_t row);
  void adapt_skin();
  void lay_out();
  double reach_of_law() const;
  double displacement() const;
  bool lists_are_due();
  void share_out();
  void keep_deepest();
  void keep_accounts();
  void throw_if_stopped();
  [[noreturn]] void throw_not_finite(std::uint32_t brick) const;

  ParticleStore& particles;
  const ContactModel& law;
  EngineOptions options;
  std::array<double, 3> size;
  std::array<bool, 3> periodic;
  Surfaces surfaces;
  similitude_contact_needs needs;         // of the law; rotation: of the effects too
  ContactEffects effects;
  Bricks bricks;
  ContactLists lists;
  CarriedHistory carried;
  ContactPass contacts;

  Column<Row> reference;                  // positions when the lists were built
  std::vector<std::uint8_t> leaves;       // per row, at a rebuild
  std::vector<std::uint32_t> new_row;
  std::vector<BrickOutcome> outcomes;
  std::vector<double> moved;              // [m], per brick in the last sub-step, at most
  Column<BlockColumns> columns;           // per thread
  std::vector<LawComplaint> complaints;   // per thread
  std::vector<ThreadShare> shares;        // per thread
  std::vector<std::vector<std::uint32_t>> pushed;   // per thread: bricks that are yet to move
  std::size_t listed_rows = 0;
  bool stale = true;                      // the lists must be built before the next sub-step, whatever moved
  double reach = 0;                       // [m], of law and effects
  double skin = 0;                        // [m]
  double skin_in_diameters = k_least_skin;   // [-], where the case gives none
  std::int64_t listed_at = 0;             // sub-step of the last rebuild
  double travel = 0;                      // [m], no particle is farther than this from its reference
  std::int64_t steps = 0;
  EngineReport report;
  StageClock clock;
};

// --------------------------------------------------------------------------------------------------------- rebuild

void Engine::Parts::wrap_positions() {
  const auto rows = static_cast<std::int64_t>(particles.size());
#pragma omp parallel for schedule(static) if (particles.size() >= k_rows_worth_threads)
  for (std::int64_t row = 0; row < rows; ++row) {
    Row& p = particles.position[static_cast<std::size_t>(row)];
    if (periodic[0] && !(p.x >= 0 && p.x < size[0])) p.x = wrapped(p.x, size[0]);
    if (periodic[1] && !(p.y >= 0 && p.y < size[1])) p.y = wrapped(p.y, size[1]);
    if (periodic[2] && !(p.z >= 0 && p.z < size[2])) p.z = wrapped(p.z, size[2]);
  }
}

void Engine::Parts::mark_leaving() {
  leaves.resize(particles.size());
  std::fill(leaves.begin(), leaves.end(), std::uint8_t{0});
  if (!surfaces.has_outlets()) return;
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (!surfaces.has_left(particles.position[row])) continue;
    leaves[row] = 1;
    ++report.removed;
    report.removed_mass += particles.velocity[row].w;
    report.removed_volume += sphere_volume(2 * particles.position[row].w);
    carry_out(row);
  }
}

/// Momentum and energy of a particle that leaves.
void Engine::Parts::carry_out(std::size_t row) {
  const Row& v = particles.velocity[row];
  ParticleBudget& budget = report.budget;
  budget.removed_momentum[0] += v.w * v.x;
  budget.removed_momentum[1] += v.w * v.y;
  budget.removed_momentum[2] += v.w * v.z;
  budget.removed_energy += 0.5 * v.w * (v.x * v.x + v.y * v.y + v.z * v.z);
  if (!particles.fields.rotation) return;
  const Row& w = particles.angular_velocity[row];
  budget.removed_energy += 0.5 * w.w * (w.x * w.x + w.y * w.y + w.z * w.z);
}

void Engine::Parts::adapt_skin() {
  const auto lasted = static_cast<double>(std::max<std::int64_t>(steps - listed_at, 1));
  const double best = std::clamp(std::sqrt(k_rebuild_price * skin_in_diameters / lasted), k_least_skin, k_most_skin);
  if (best > k_worth_a_change * skin_in_diameters || skin_in_diameters > k_worth_a_change * best) skin_in_diameters = best;
}

/// [m], at the largest particle's diameter.
double Engine::Parts::reach_of_law() const {
  double largest_radius = 0;
  for (const Row& p : particles.position) largest_radius = std::max(largest_radius, p.w);
  return reach_of(law, 2 * largest_radius);
}

void Engine::Parts::lay_out() {
  double largest_radius = 0;
  for (const Row& p : particles.position) largest_radius = std::max(largest_radius, p.w);
  const double of_law = reach_of_law();
  reach = std::max(of_law, effects.reach(2 * largest_radius));
  contacts.set_reach(of_law, reach);
  skin = options.skin > 0 ? options.skin : skin_in_diameters * 2 * largest_radius;
  const double cut_off = 2 * largest_radius + reach + skin;
  if (cut_off != bricks.cut_off()) bricks.lay_out(size, periodic, cut_off);
}

void Engine::Parts::rebuild() {
  keep_deepest();
  wrap_positions();
  mark_leaving();
  if (!stale) adapt_skin();   // motion brought this rebuild about
  if (particles.size() > 0) lay_out();
  bricks.sort(particles, leaves);
  const std::vector<std::uint32_t>& order = bricks.order();
  new_row.resize(particles.size());
  std::fill(new_row.begin(), new_row.end(), CarriedHistory::k_gone);
  for (std::uint32_t row = 0; row < order.size(); ++row) new_row[order[row]] = row;
  particles.reorder(order, reference);   // written anew below
  carried.collect(lists, new_row, order.size());
  build_lists(order.size());
  travel = 0;
  listed_at = steps;
  stale = false;
  ++report.rebuilds;
  clock.lap(Stage::list);
}

/// At the present positions of sorted rows.
void Engine::Parts::build_lists(std::size_t rows) {
  double largest_radius = 0;
  for (const Row& p : particles.position) largest_radius = std::max(largest_radius, p.w);
  lists.build(particles, bricks, surfaces, reach + skin, largest_radius, carried);
  contacts.make_room();

  reference.resize(rows);
  std::copy(particles.position.begin(), particles.position.end(), reference.begin());
  outcomes.reserve(bricks.most());
  outcomes.resize(bricks.count());
  moved.reserve(bricks.most());
  for (std::vector<std::uint32_t>& waiting : pushed) waiting.reserve(bricks.most());
  moved.resize(bricks.count());
  for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) outcomes[brick] = {};
  listed_rows = rows;
}

double Engine::Parts::displacement() const {
  double farthest = 0;
#pragma omp parallel for schedule(static) reduction(max : farthest) if (listed_rows >= k_rows_worth_threads)
  for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) {
    farthest = std::max(farthest, largest_displacement_squared(particles, reference, bricks.first_row(brick), bricks.end_row(brick)));
  }
  return std::sqrt(farthest);
}

/// Two particles that came toward each other by the skin may touch unlisted. Looking at all positions is put off while the
/// fastest particle cannot have come so far; the answer is the same as that of looking every time.
bool Engine::Parts::lists_are_due() {
  if (stale) return true;
  constexpr double rounding = 1 + 1e-9;
  if (travel * rounding <= 0.5 * skin) return false;
  travel = displacement();
  clock.lap(Stage::list);
  return travel > 0.5 * skin;
}

// -------------------------------------------------------------------------------------------------------- sub-steps

/// Each thread gets bricks that lie together, the same ones as long as the bed stands: what a core wrote is still in its cache
/// in the next sub-step. No sum depends on who does what.
void Engine::Parts::share_out() {
  constexpr std::size_t contact_price = 2;   // in rows: what a contact costs over what a row does, about
  const auto work = [&](std::uint32_t brick) {
    return bricks.end_row(brick) - bricks.first_row(brick) + contact_price * outcomes[brick].contacts;
  };
  std::size_t all = 0, given = 0;
  for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) all += work(brick);
  std::uint32_t brick = 0;
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    shares[thread].next = brick;
    while (brick < bricks.count() && (given + work(brick) / 2) * shares.size() < all * (thread + 1)) given += work(brick++);
    shares[thread].end = thread + 1 < shares.size() ? brick : bricks.count();
  }
}

void Engine::Parts::sub_step() {
  if (lists_are_due()) rebuild();
  const Motion motion{options.dt, options.gravity, options.velocity_damping};
  const bool rotation = needs.rotation != 0;
  const bool outlets = surfaces.has_outlets();
  share_out();
#pragma omp parallel if (listed_rows >= k_rows_worth_threads)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const bool main_thread = thread == 0;
    const auto lap = [&](Stage stage) {
      if (main_thread) clock.lap(stage);
    };
    const auto push = [&](std::uint32_t brick) {
      BrickOutcome& outcome = outcomes[brick];
      outcome.contacts = contacts.pairs(brick, options.dt, columns[thread], outcome.deepest, complaints[thread]);
      lap(Stage::contacts);
      outcome.contacts += contacts.surfaces(brick, options.dt, columns[thread], outcome.wall_force, outcome.deepest, complaints[thread]);
      lap(Stage::walls);
      std::atomic_ref(outcome.pushed_in).store(steps, std::memory_order_release);
    };
    // A brick moves as soon as the last of the pairs that look at it has been pushed, its rows still in the cache: pairs look
    // from a brick at itself and at later ones.
    const auto may_move = [&](std::uint32_t brick) {
      for (std::uint32_t n = lists.first_earlier[brick]; n < lists.first_earlier[brick + 1]; ++n) {
        if (std::atomic_ref(outcomes[lists.earlier[n]].pushed_in).load(std::memory_order_acquire) != steps) return false;
      }
      return true;
    };
    const auto move = [&](std::uint32_t brick) {
      const std::uint32_t begin = bricks.first_row(brick), end = bricks.end_row(brick);
      contacts.collect_shares(brick);
      lap(Stage::exchange);
      BrickOutcome& outcome = outcomes[brick];
      outcome.motion = integrate(particles, begin, end, motion, rotation);
      outcome.left = false;
      if (outlets) {
        for (std::uint32_t row = begin; row < end; ++row) outcome.left |= surfaces.has_left(particles.position[row]);
      }
      lap(Stage::integrate);
    };
    std::vector<std::uint32_t>& waiting = pushed[thread];
    waiting.clear();
    for (std::size_t turn = 0; turn < shares.size(); ++turn) {   // its own share first, then what others have left
      ThreadShare& share = shares[(thread + turn) % shares.size()];
      for (;;) {
        const std::uint32_t brick = std::atomic_ref(share.next).fetch_add(1, std::memory_order_relaxed);
        if (brick >= share.end) break;
        push(brick);
        waiting.push_back(brick);
        std::erase_if(waiting, [&](std::uint32_t other) {
          if (!may_move(other)) return false;
          move(other);
          return true;
        });
      }
    }
    for (const std::uint32_t brick : waiting) {
      while (!may_move(brick)) std::this_thread::yield();   // another thread is pushing its last brick
      lap(Stage::waiting);
      move(brick);
    }
#pragma omp barrier
    lap(Stage::waiting);
  }
  ++steps;
  throw_if_stopped();

  double fastest = 0;
  for (const BrickOutcome& outcome : outcomes) {
    fastest = std::max(fastest, outcome.motion.largest_speed_squared);
    stale |= outcome.left;
  }
  keep_accounts();
  report.largest_speed = std::sqrt(fastest);
  for (std::size_t brick = 0; brick < outcomes.size(); ++brick) {
    moved[brick] = options.dt * std::sqrt(outcomes[brick].motion.largest_speed_squared);
  }
  lists.have_moved(moved);
  travel += options.dt * report.largest_speed;
  report.particle_steps += listed_rows;
}

/// Once per sub-step and in the order of bricks: the same bits for any number of threads and any division into calls.
void Engine::Parts::keep_accounts() {
  const double dt = options.dt;
  ParticleBudget& budget = report.budget;
  const auto add = [](ParticleBudget::Vector& to, double factor, const Row& row) {
    to[0] += factor * row.x;
    to[1] += factor * row.y;
    to[2] += factor * row.z;
  };
  const auto work = [dt](const Row& power) { return dt * (power.x + power.y + power.z); };
  for (const BrickOutcome& outcome : outcomes) {
    const MotionSums& sums = outcome.motion.sums;
    const auto& g = options.gravity;
    add(budget.gravity_impulse, dt * sums.mass.w, {g[0], g[1], g[2], 0});
    add(budget.drag_impulse, dt, sums.drag);
    add(budget.stress_impulse, dt, sums.stress);
    add(budget.wall_impulse, dt, outcome.wall_force);
    budget.gravity_work += work(sums.gravity_power);
    budget.drag_work += work(sums.drag_power);
    budget.stress_work += work(sums.stress_power);
    budget.contact_work += work(sums.contact_power);
  }
}

void Engine::Parts::advance(std::int64_t sub_steps) {
  clock.start();
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  if (columns.size() < threads) {
    columns.resize(threads);
    complaints.resize(threads);
    pushed.resize(threads);
    for (std::vector<std::uint32_t>& waiting : pushed) waiting.reserve(bricks.most());
    shares.resize(threads);
  }
  report.largest_overlap = {};
  for (BrickOutcome& outcome : outcomes) outcome.deepest = {};
  lists.were_moved_from_outside();
  // Others may have added particles or moved them since.
  if (particles.size() != listed_rows) {
    stale = true;
  } else if (!stale) {
    travel = displacement();
  }
  for (std::int64_t n = 0; n < sub_steps; ++n) sub_step();
  report.contacts = 0;
  for (const BrickOutcome& outcome : outcomes) report.contacts += outcome.contacts;
  if (stale && particles.size() > 0 && sub_steps > 0) rebuild();   // who has left must not be seen outside
  keep_deepest();
}

void Engine::Parts::keep_deepest() {
  for (BrickOutcome& outcome : outcomes) {
    const DeepestContact& deepest = outcome.deepest;
    if (0.5 * deepest.twice_ratio > report.largest_overlap.overlap_ratio) {
      const std::uint64_t partner = deepest.surface ? ~std::uint64_t{0} : particles.id[deepest.partner];
      report.largest_overlap = {0.5 * deepest.twice_ratio, particles.id[deepest.owner], partner, deepest.place};
    }
    outcome.deepest = {};
  }
}

void Engine::Parts::throw_if_stopped() {
  const LawComplaint* first = nullptr;
  for (const LawComplaint& complaint : complaints) {
    if (complaint.raised && (!first || complaint.brick < first->brick)) first = &complaint;
  }
  if (first) {
    std::string who = "a contact";
    if (first->owner < particles.size()) {
      const Row& p = particles.position[first->owner];
      who = "particle " + std::to_string(particles.id[first->owner]) + " at " + at_place(p.x, p.y, p.z);
    }
    const std::string text = first->text;
    for (LawComplaint& complaint : complaints) complaint = {};
    const std::string what = first->effect ? std::string("The effect ") + first->effect : std::string("The contact law ") + law.descriptor().id;
    throw SimulationError(what + " stopped the run for " + who + " in sub-step " +
                              std::to_string(steps) + ": " + text,
                          "");
  }
  for (std::uint32_t brick = 0; brick < outcomes.size(); ++brick) {
    if (!outcomes[brick].motion.finite) throw_not_finite(brick);
  }
}

void Engine::Parts::throw_not_finite(std::uint32_t brick) const {
  std::uint32_t row = bricks.first_row(brick);
  const auto finite = [](const Row& r) { return std::isfinite(r.x + r.y + r.z + r.w); };
  for (; row + 1 < bricks.end_row(brick); ++row) {
    if (!finite(particles.position[row]) || !finite(particles.velocity[row])) break;
    if (needs.rotation && !finite(particles.angular_velocity[row])) break;
  }
  const Row& last = reference[row];
  throw SimulationError("Particle " + std::to_string(particles.id[row]) + " has a position or velocity that is not a finite number after sub-step " +
                            std::to_string(steps) + "; it was last listed at " + at_place(last.x, last.y, last.z) + ".",
                        "Usually the time step is too long for the contact stiffness, or particles overlap at the start: "
                        "compare time.dt with the limits that `similitude check` prints.");
}

// ----------------------------------------------------------------------------------------------------- checkpoints

void Engine::Parts::save(EngineState& state) const {
  state.listed = listed_rows > 0 && listed_rows == particles.size();
  state.stale = stale;
  state.cut_off = bricks.cut_off();
  state.reach = reach;
  state.skin = skin;
  state.skin_in_diameters = skin_in_diameters;
  state.listed_at = listed_at;
  state.steps = steps;
  state.report = report;
  if (!state.listed) {
    state.reference.clear();
    state.touching = {};
    return;
  }
  state.reference = reference;
  collect_touching(lists, state.touching);
}

/// Lists hold rows, so rows sorted by the positions of then must be those that stand there now.
void Engine::Parts::sort_as_before() {
  leaves.assign(particles.size(), 0);
  bricks.sort(particles, leaves);
  const std::vector<std::uint32_t>& order = bricks.order();
  for (std::uint32_t row = 0; row < order.size(); ++row) {
    if (order[row] != row) throw std::invalid_argument("the rows are not in the order in which lists were built");
  }
}

void Engine::Parts::restore(const EngineState& state) {
  report = state.report;
  skin_in_diameters = state.skin_in_diameters;
  listed_at = state.listed_at;
  steps = state.steps;
  stale = true;
  listed_rows = 0;
  lists.bricks.clear();   // nothing is carried over from them
  if (!state.listed) return;
  if (state.reference.size() != particles.size()) throw std::invalid_argument("as many rows as lists were built for are needed");
  reach = state.reach;
  contacts.set_reach(reach_of_law(), reach);
  skin = state.skin;
  bricks.lay_out(size, periodic, state.cut_off);
  Column<Row> now = state.reference;
  particles.position.swap(now);
  sort_as_before();
  carried.clear();
  build_lists(particles.size());
  particles.position.swap(now);
  if (!give_back_touching(state.touching, lists)) throw std::invalid_argument("a contact that touched is not in the lists");
  stale = state.stale;
}

// --------------------------------------------------------------------------------------------------------- outside

Engine::Engine(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const EngineOptions& options,
               std::span<const EffectModel> effects)
    : parts_(std::make_unique<Parts>(particles, scene, law, options, effects)) {}
Engine::~Engine() = default;

void Engine::advance(std::int64_t sub_steps) { parts_->advance(sub_steps); }

void Engine::set_options(const EngineOptions& options) {
  if (options.skin != parts_->options.skin) parts_->stale = true;
  parts_->options = options;
}

void Engine::save(EngineState& state) const { parts_->save(state); }
void Engine::restore(const EngineState& state) { parts_->restore(state); }

void Engine::touching(TouchingContacts& out) const { collect_touching(parts_->lists, out); }

const EngineReport& Engine::report() const { return parts_->report; }

std::vector<StageTime> Engine::stage_times() const {
  std::vector<StageTime> out;
  for (std::size_t stage = 0; stage < k_stage_count; ++stage) {
    out.push_back({k_stage_names[stage], parts_->clock.seconds(stage)});
  }
  return out;
}

std::vector<std::string> Engine::passes() const {
  const Parts& p = *parts_;
  std::vector<std::string> out;
  out.push_back("neighbour list (half lists by bricks, rebuilt when a particle has moved by half the skin)");
  out.push_back("contacts (" + std::string(p.law.descriptor().id) + ", " + std::to_string(p.needs.history_count) +
                " history values, " + (p.needs.rotation ? "with" : "without") + " rotation" +
                (p.law.sets() > 1 ? ", " + std::to_string(p.law.sets()) + " pairs of materials)" : ")") +
                (p.effects.empty() ? "" : " and " + p.effects.names() + " (effects, " +
                 std::to_string(p.effects.memory().count - p.needs.history_count) + " history values)"));
  out.push_back("walls (" + std::to_string(p.surfaces.count()) + " surfaces)");
  out.push_back("exchange (shares of contacts across bricks)");
  out.push_back(std::string("integrate (semi-implicit Euler") + (p.particles.fields.coupling ? ", drag implicit)" : ")"));
  return out;
}

EngineMemory engine_memory(std::uint32_t history_values, bool rotation, bool periodic) {
  const std::size_t history_rows = ContactMemory{.count = history_values}.rows();
  EngineMemory memory;
  memory.lists_per_particle = sizeof(Row) + Bricks::k_bytes_per_row + sizeof(std::uint32_t) + sizeof(std::uint8_t);   // new_row, leaves
  memory.lists_per_candidate = ContactLists::k_room * static_cast<double>(ContactLists::bytes_per_candidate(periodic));
  memory.lists_per_crossing = ContactLists::k_room * static_cast<double>(sizeof(Incoming) + (rotation ? 2 : 1) * sizeof(Row));
  memory.history_per_candidate = ContactLists::k_room * static_cast<double>(history_rows * sizeof(Row));
  memory.history_per_contact = static_cast<double>(CarriedHistory::bytes_per_contact(history_rows));
  return memory;
}

std::size_t Engine::list_bytes() const {
  return parts_->lists.bytes() + parts_->contacts.bytes() + parts_->bricks.bytes() + parts_->reference.capacity() * sizeof(Row) +
         parts_->new_row.capacity() * sizeof(std::uint32_t) + parts_->leaves.capacity() + parts_->outcomes.capacity() * sizeof(BrickOutcome);
}
std::size_t Engine::history_bytes() const { return parts_->lists.history_bytes() + parts_->carried.bytes(); }

}  // namespace similitude
