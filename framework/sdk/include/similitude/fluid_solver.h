#pragma once
/// All that the author of a fluid solver includes. A solver is a type with
///
///   void initialise(const similitude_grid&, const similitude_gas_step& fields);      once: keep the grid, fill the fields
///   void advance(const similitude_gas_step&, similitude_gas_report&);                one gas step, [main]
///
/// What either throws stops the run with its own words: what is wrong and, on an indented line, how to mend it. What a
/// solver may add:
///
///   static void parameters(Parameters<Solver>&);               its parameters
///   void prepare();  void prepare(const Bed&);                 once the parameters are in: gas density, viscosity
///   static constexpr bool sees_particles = false;              a given gas that needs no solids fraction
///   double largest_stable_step(const similitude_grid&) const;  [s], hard limits of explicit parts other than CFL. [setup]
///   similitude_fluid_needs needs() const;                      how it differs from model A with inertia. [setup]
///   std::uint64_t state_size() const;                          numbers beyond the step's fields, for checkpoints; with
///   void save_state(double*) const;  void load_state(const double*);   [main]
///
/// An exception out of needs refuses the solver, one out of the three of the state ends the run; its words are told to the user.
///
/// Solvers may link libsimilitude for index arithmetic on the grid (fluid/staggered.h) and for the pressure equation
/// (fluid/multigrid_cg.h), or derive from what solvers with velocities on faces share (fluid/face_flow.h).

#include <limits>
#include <stdexcept>

#include <similitude/plugin.h>

namespace similitude {

/// What state_size answers if the solver threw.
inline constexpr std::uint64_t k_unknown_size = std::numeric_limits<std::uint64_t>::max();

/// The boundary's functions for one solver type.
template <class Solver>
struct FluidTable {
  static constexpr bool has_limit =
      requires(const Solver& s, const similitude_grid& grid) { s.largest_stable_step(grid); };
  static constexpr bool has_state = requires(Solver& s, double* out, const double* in) {
    s.state_size();
    s.save_state(out);
    s.load_state(in);
  };

  static constexpr bool has_needs = requires(const Solver& s) { s.needs(); };

  static constexpr bool couples() {
    if constexpr (requires { Solver::sees_particles; }) return Solver::sees_particles;
    return true;
  }

  static void initialise(void* model, const similitude_grid* grid, const similitude_gas_step* fields,
                         similitude_status* status) noexcept {
    guarded(status, -1, [&] { model_of<Solver>(model).initialise(*grid, *fields); });
  }

  static void advance(void* model, const similitude_gas_step* step, similitude_gas_report* report,
                      similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if (static_cast<const Made<Solver>*>(model)->half_loaded)
        throw std::runtime_error("load_state() failed, so that the gas would not go on as it was; what it threw stands above.");
      similitude_gas_report known{};
      known.struct_size = report->struct_size;
      model_of<Solver>(model).advance(as_known_here(step), known);
      std::memcpy(static_cast<void*>(report), &known, std::min<std::size_t>(report->struct_size, sizeof known));
    });
  }

  static double largest_stable_step(const void* model, const similitude_grid* grid) noexcept {
    if constexpr (has_limit) {
      return number_or_nan<Solver>(model, "largest_stable_step",
                                   [&]() -> double { return model_of<Solver>(model).largest_stable_step(*grid); });
    } else {
      return std::numeric_limits<double>::infinity();
    }
  }
  /// What these three throw goes to the host's log. The host refuses the answer of the first two; after the third the next step does.
  static std::uint64_t state_size(const void* model) noexcept {
    std::uint64_t size = 0;
    if constexpr (has_state) {
      if (!told<Solver>(model, "state_size", [&] { size = model_of<Solver>(model).state_size(); })) return k_unknown_size;
    }
    return size;
  }
  static void save_state(const void* model, double* out) noexcept {
    if constexpr (has_state) {
      if (!told<Solver>(model, "save_state", [&] { model_of<Solver>(model).save_state(out); }) && out) *out = not_given;
    }
  }
  static void load_state(void* model, const double* in) noexcept {
    if constexpr (has_state) {
      const bool loaded = told<Solver>(model, "load_state", [&] { model_of<Solver>(model).load_state(in); });
      static_cast<Made<Solver>*>(model)->half_loaded = !loaded;
    }
  }

  /// What `needs` asks the solver is asked once here, where a refusal still has words.
  static void* create(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, std::uint32_t sets,
                      similitude_status* status) noexcept {
    return create_and_ask<Solver>(host, bed, values, sets, status, []([[maybe_unused]] const Solver& solver) {
      if constexpr (has_needs) static_cast<void>(solver.needs());
    });
  }

  static void needs(const void* model, similitude_fluid_needs* out) noexcept {
    if constexpr (has_needs) {
      similitude_fluid_needs n = model_of<Solver>(model).needs();
      n.struct_size = out->struct_size;
      std::memcpy(static_cast<void*>(out), &n, std::min<std::size_t>(out->struct_size, sizeof n));
    }
  }

  static constexpr similitude_fluid_functions functions = {
      sizeof(similitude_fluid_functions),
      couples() ? 1 : 0,
      &initialise,
      &advance,
      has_limit ? &largest_stable_step : nullptr,
      has_state ? &state_size : nullptr,
      has_state ? &save_state : nullptr,
      has_state ? &load_state : nullptr,
      has_needs ? &needs : nullptr};
};

template <class Solver>
similitude_descriptor fluid_solver(const About& about) {
  similitude_descriptor d = describe_model<Solver>("fluid", &FluidTable<Solver>::functions, about);
  d.create = &FluidTable<Solver>::create;
  return d;
}

}  // namespace similitude

/// SIMILITUDE_FLUID_SOLVER(Solver, id, version, title [, authors [, reference]])
#define SIMILITUDE_FLUID_SOLVER(Solver, ...) SIMILITUDE_PLUGIN(similitude::fluid_solver<Solver>({__VA_ARGS__}))
