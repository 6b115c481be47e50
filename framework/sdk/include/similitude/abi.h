/*
 * The boundary between Similitude and its plugins: plain C structures, nothing else.
 *
 * Frozen as 1.0: a minor version appends and changes nothing else (docs/plugin-authors/promise.md).
 * A structure that may grow does so at its end and has its own size in struct_size, which stands first (in the tag: behind the magic); those
 * without, and those that stand in arrays, never grow: status, parameter, value, patch, quantity, gas_scalar_law, range.
 * Whoever makes a structure sets struct_size to the size that he knows: the plugin that of its tables, the host that of everything else,
 * also of what a plugin fills (needs, ratios, relevance, gas_report); a plugin writes no byte beyond it and leaves it as it is. What a
 * plugin fills arrives zeroed, but ratios as the identity, a verdict as -1, and arrays of rows with what is said at them.
 * A null function pointer is a hook the plugin does not have. No exception, standard-library type or Eigen type crosses. Strings are UTF-8, zero-ended,
 * static, and owned by whoever wrote them. Quantities are SI. Plugins are loaded once and never unloaded.
 *
 * Phases: [setup] once, main thread, before the first step. [main] main thread, between sub-steps.
 *         [worker] concurrently from several threads on different blocks; the model must not change itself.
 *
 * C++ authors do not fill these by hand: see contact_law.h, drag_law.h, scaling_law.h, fluid_solver.h, effect.h.
 */
#ifndef SIMILITUDE_ABI_H
#define SIMILITUDE_ABI_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SIMILITUDE_ABI_MAJOR 1
#define SIMILITUDE_ABI_MINOR 0

/* Fingerprint of where every field lies that existed in 1.0. layout.h computes it and compares; it changes with the major
 * version only. */
#define SIMILITUDE_LAYOUT_HASH 0x12cb8fbeu

/* The one symbol a plugin exports, and the ELF section its tag lies in. */
#define SIMILITUDE_ENTRY_SYMBOL "similitude_plugin"
#define SIMILITUDE_TAG_SECTION ".similitude_tag"
#define SIMILITUDE_TAG_MAGIC "SIMILTD"

/* ---------------------------------------------------------------------------------------------- tag and entry */

/* Read from the file as bytes before the library is mapped, so that a library this program or this processor
 * cannot run is refused in words. No pointers. */
typedef struct similitude_tag {
  char magic[8];              /* SIMILITUDE_TAG_MAGIC */
  uint32_t struct_size;
  uint16_t abi_major;         /* must equal the host's */
  uint16_t abi_minor;         /* at most the host's */
  uint32_t layout_hash;       /* of the fields that existed in <major>.0; must equal the host's */
  uint32_t reserved;
  char compiler[48];          /* "gcc 12.2.0": told to the user, not compared */
  char instruction_set[32];   /* "x86-64-v3": the processor must have it */
} similitude_tag;

typedef struct similitude_status {
  int32_t code;               /* 0: fine */
  int32_t row;                /* first offending row of a block, or -1 */
  char text[504];             /* what is wrong and how to mend it */
} similitude_status;

enum { SIMILITUDE_REAL = 0, SIMILITUDE_INTEGER = 1, SIMILITUDE_FLAG = 2, SIMILITUDE_CHOICE = 3 };

/* How the framework turns a real-bed parameter into the simulated bed's. */
enum {
  SIMILITUDE_SCALES_NOT = 0,
  SIMILITUDE_SCALES_AS_LENGTH = 1,     /* positions, geometry */
  SIMILITUDE_SCALES_AS_DIAMETER = 2,   /* particle-sized lengths */
  SIMILITUDE_SCALES_AS_TIME = 3,
  SIMILITUDE_SCALES_AS_VELOCITY = 4,
  SIMILITUDE_SCALES_AS_STIFFNESS = 5,  /* spring stiffness, force per length */
  SIMILITUDE_SCALES_AS_MODULUS = 6,    /* elastic modulus, force per area */
  SIMILITUDE_SCALES_AS_RESTITUTION = 7,    /* coefficient of restitution e: 1 - e^2 scales by energy_loss */
  SIMILITUDE_SCALES_AS_FORCE = 8,          /* on what touches: as a simulated particle's weight, so a Bond number stays */
  SIMILITUDE_SCALES_AS_SURFACE_ENERGY = 9, /* force per particle-sized length */
  SIMILITUDE_SCALES_AS_ENERGY = 10,        /* force times particle-sized length */
  SIMILITUDE_SCALES_AS_DIFFUSIVITY = 11,   /* drag diameter^2 / time: a particle's Fourier number stays */
  SIMILITUDE_SCALES_AS_RATE = 12,          /* 1 / time */
  SIMILITUDE_SCALES_REFUSED = 13           /* nothing is known: a scaled run with this model is an error */
};

typedef struct similitude_parameter {
  uint32_t struct_size;
  int32_t type;               /* SIMILITUDE_REAL ... */
  int32_t required;           /* 1: the case must give it */
  int32_t scales_as;          /* SIMILITUDE_SCALES_... */
  const char* name;           /* lower_snake */
  const char* unit;           /* "N/m", "1" for a pure number; empty for flags and choices */
  const char* doc;            /* one sentence */
  const char* reference;      /* where it comes from, or null */
  const char* choices;        /* "a|b|c" for SIMILITUDE_CHOICE, else null */
  const char* default_text;   /* of a choice, else null */
  double default_value;       /* NaN: left out means "not given", and the model is told NaN */
  double minimum, maximum;    /* hard; -inf/inf where open */
  double typical_minimum, typical_maximum;   /* outside: a warning; equal: no typical range */
  const char* taken_from;     /* kind of the model whose parameter of the same name is meant where the case gives none; or null */
} similitude_parameter;

typedef struct similitude_value {
  double real;                /* of reals, integers and flags (0 or 1) */
  const char* text;           /* of choices, valid during the call; else null */
} similitude_value;

/* The bed a model is created for: the simulated one, or the real one for a scaling law. */
typedef struct similitude_bed {
  uint32_t struct_size;
  uint32_t dimension;             /* 3 */
  double gravity;                 /* [m/s^2], magnitude */
  double gas_density;             /* [kg/m^3] */
  double gas_viscosity;           /* [Pa s] */
  double particle_diameter;       /* [m], of the first class, in evidence of the one that is judged; what touches */
  double particle_density;        /* [kg/m^3] */
  double drag_diameter;           /* [m], the diameter drag laws see */
  double bed_width, bed_depth, bed_height;   /* [m], domain width and depth, settled height or 0 if unknown */
  double superficial_velocity;    /* [m/s], mean over the bottom at full flow */
  double largest_inlet_velocity;  /* [m/s] */
  double particle_count;
  double largest_shear_rate;      /* [1/s], of the inlets and walls: a jet's speed over half its width, or the mean's over half
                                     the bed's; 0 without a flow */
} similitude_bed;

/* What the host offers a plugin. Valid for the life of the process. */
typedef struct similitude_host {
  uint32_t struct_size;
  uint16_t abi_major, abi_minor;
  void (*log)(int32_t level, const char* text);   /* 0 note, 1 warning. [setup][main] */
} similitude_host;

typedef struct similitude_descriptor {
  uint32_t struct_size;
  uint32_t parameter_count;
  const char* kind;           /* "drag" "contact" "fluid" "scaling" "effect" */
  const char* id;             /* "gidaspow", or "org.example.my_law" for third parties; for ever */
  const char* version;        /* "1.0.0" */
  const char* title;
  const char* authors;        /* or null */
  const char* reference;      /* or null */
  const similitude_parameter* parameters;
  const void* functions;      /* similitude_<kind>_functions */
  /* `values` holds `sets` rows of parameter_count values (contact: a set per material pair; others: one set).
   * Returns null and fills `status` on refusal; never throws. [setup] */
  void* (*create)(const similitude_host*, const similitude_bed*, const similitude_value* values, uint32_t sets,
                  similitude_status* status);
  void (*destroy)(void* model);   /* once, when nothing of the model runs any more; never throws. [setup][main] */
} similitude_descriptor;

typedef struct similitude_entry {
  uint32_t struct_size;
  uint32_t descriptor_count;
  const similitude_tag* tag;
  const similitude_descriptor* const* descriptors;
} similitude_entry;

/* ------------------------------------------------------------------------------------------------------ blocks */

/* Rows of a block are columns of doubles, 64-byte aligned. `rows` is a multiple of SIMILITUDE_ROW_MULTIPLE: the
 * host pads with harmless copies, so that a model never needs a remainder loop and block edges change no bit. */
#define SIMILITUDE_ROW_MULTIPLE 8
#define SIMILITUDE_MAX_HISTORY 8

/* ------------------------------------------------------------------------------------------------------ contact */

enum { SIMILITUDE_EVEN = 0, SIMILITUDE_ODD = 1 };   /* does a history value change sign when the partners swap? */

typedef struct similitude_contact_needs {
  uint32_t struct_size;
  uint32_t history_count;                           /* <= SIMILITUDE_MAX_HISTORY */
  int32_t rotation;                                 /* 1: particles have angular velocity, forces have torques */
  int32_t couple;                                   /* 1: the law returns a pure couple as well */
  int32_t history_parity[SIMILITUDE_MAX_HISTORY];
  const char* history_name[SIMILITUDE_MAX_HISTORY];
  const char* history_unit[SIMILITUDE_MAX_HISTORY];
} similitude_contact_needs;

/* A block of contacts between partners i and j. A wall is a partner of infinite mass and radius. [worker] */
typedef struct similitude_contact_block {
  uint32_t struct_size;
  uint32_t rows;
  double dt;                            /* [s] */
  const double* normal[3];              /* [-], unit, from partner j toward partner i */
  const double* overlap;                /* [m], positive in contact; may be negative down to -reach */
  const double* velocity[3];            /* [m/s], of i relative to j at the contact point; spin included if rotation */
  const double* angular_velocity_i[3];  /* [rad/s]; null without rotation */
  const double* angular_velocity_j[3];
  const double* radius_i;               /* [m] */
  const double* radius_j;               /* [m], infinite for a flat wall */
  const double* effective_mass;         /* [kg], m_i m_j / (m_i + m_j) */
  const uint32_t* pair;                 /* material pair = parameter set; null: all rows use set 0 */
  double* history[SIMILITUDE_MAX_HISTORY];   /* in and out; zero in the first step of a contact */
  double* force[3];                     /* out [N], on i; j receives the opposite */
  double* couple[3];                    /* out [N m], pure couple on i; null unless needed */
} similitude_contact_block;

typedef struct similitude_contact_functions {
  uint32_t struct_size;
  uint32_t reserved;
  void (*needs)(const void* model, similitude_contact_needs* out);                         /* [setup] */
  void (*forces)(const void* model, const similitude_contact_block* block, similitude_status* status);   /* [worker] */
  /* [s], of a head-on impact at relative speed v. [setup] */
  double (*contact_time)(const void* model, uint32_t pair, double effective_mass, double effective_radius, double speed);
  /* [s], beyond it explicit steps of a packed bed are unstable. [setup] */
  double (*largest_stable_step)(const void* model, uint32_t pair, double effective_mass, double effective_radius,
                                double speed);
  double (*reach)(const void* model, double diameter);                 /* [m], optional: null means 0. [setup] */
} similitude_contact_functions;

/* --------------------------------------------------------------------------------------------------------- drag */

typedef struct similitude_drag_block {
  uint32_t struct_size;
  uint32_t rows;
  const double* diameter;         /* [m] */
  const double* gas_fraction;     /* [-], eps, in (0, 1] */
  const double* slip_speed;       /* [m/s], |u - v|, interstitial, >= 0 */
  const double* gas_density;      /* [kg/m^3] */
  const double* gas_viscosity;    /* [Pa s] */
  const double* sauter_diameter;  /* [m]; null unless needed */
  const double* cell_size;        /* [m]; null unless needed */
  double* exchange;               /* out: K [kg/s] of ONE physical particle, F = K (u - v), model A: K = (beta/phi) V_p */
} similitude_drag_block;

typedef struct similitude_drag_needs {
  uint32_t struct_size;
  int32_t sauter_diameter, cell_size;   /* 1: fill that column */
} similitude_drag_needs;

typedef struct similitude_drag_functions {
  uint32_t struct_size;
  uint32_t reserved;
  void (*needs)(const void* model, similitude_drag_needs* out);        /* optional. [setup] */
  void (*exchange)(const void* model, const similitude_drag_block* block, similitude_status* status);    /* [worker] */
} similitude_drag_functions;

/* ------------------------------------------------------------------------------------------------------ scaling */

/* Ratios simulated / real. 1 everywhere is the identity. */
typedef struct similitude_ratios {
  uint32_t struct_size;
  uint32_t reserved;
  double length;              /* r: geometry */
  double diameter;            /* n: what touches */
  double drag_diameter;       /* what drag laws see; differs from `diameter` only for parcels */
  double particle_density;
  double gas_density;
  double gas_viscosity;
  double velocity;
  double time;
  double stiffness;           /* of springs */
  double modulus;             /* of elastic moduli */
  double energy_loss;         /* (1 - e^2) */
  double parcel_weight;       /* physical particles that one simulated particle stands for */
} similitude_ratios;

typedef struct similitude_scaling_functions {
  uint32_t struct_size;
  uint32_t reserved;
  void (*ratios)(const void* model, const similitude_bed* real, similitude_ratios* out, similitude_status* status);  /* [setup] */
} similitude_scaling_functions;

/* -------------------------------------------------------------------------------------------------------- fluid */

enum { SIMILITUDE_FACE_OPEN = 0, SIMILITUDE_FACE_NO_SLIP = 1, SIMILITUDE_FACE_SLIP = 2, SIMILITUDE_FACE_PATCH = 3 };
enum { SIMILITUDE_PATCH_VELOCITY = 0, SIMILITUDE_PATCH_PRESSURE = 1 };

/* A patch of the boundary: an inlet of given superficial velocity or an opening of given pressure. */
typedef struct similitude_patch {
  uint32_t struct_size;
  int32_t kind;               /* SIMILITUDE_PATCH_... */
  const char* name;
  double velocity[3];         /* [m/s], full value; the normal part is the superficial velocity into the domain */
  double pressure;            /* [Pa], above rho g.x */
  double ramp;                /* [s], the velocity grows linearly from zero over this time; 0: at once */
} similitude_patch;

/* Uniform Cartesian cells. Cell (i,j,k) is row i + nx (j + ny k). Faces normal to x: i + (nx+1) (j + ny k), face i
 * lies between cells i-1 and i; faces normal to y: i + nx (j + (ny+1) k); to z: i + nx (j + ny k).
 * face_kind is SIMILITUDE_FACE_...; SIMILITUDE_FACE_PATCH + p stands for patch p. Inside the domain a face that is not
 * open is a baffle side. In a periodic direction the first and last face are open and the same face. */
typedef struct similitude_grid {
  uint32_t struct_size;
  int32_t cells[3];
  int32_t periodic[3];
  uint32_t patch_count;
  double spacing[3];          /* [m] */
  double origin[3];           /* [m], lower corner */
  double gravity[3];          /* [m/s^2] */
  const uint8_t* face_kind[3];
  const similitude_patch* patches;
} similitude_grid;

/* One gas step, seen by the fluid plugin. The host owns all arrays. 3 x cells means x of all cells, then y, then z.
 * [main] between DEM sub-steps. */
typedef struct similitude_gas_step {
  uint32_t struct_size;
  uint32_t reserved;
  double time;                      /* [s], at the end of the step */
  double dt;                        /* [s], a whole number of DEM sub-steps */
  /* in */
  const double* gas_fraction;       /* [-], cells, end of step */
  const double* gas_fraction_old;   /* [-], cells, start of step */
  const double* exchange;           /* [kg/(m^3 s)], cells: sum of K per volume; the implicit part of drag */
  const double* exchange_velocity;  /* [kg/(m^2 s^2)], 3 x cells: sum of K v per volume */
  const double* remainder;          /* [N/m^3], 3 x cells: impulse owed to the gas from the last step; add explicitly */
  /* in and out: last step's values on entry */
  double* velocity;                 /* [m/s], 3 x cells, interstitial, mean of the two faces (an inlet face: of its flux between
                                       the cell's particles) */
  double* pressure;                 /* [Pa], cells, full pressure minus rho g.x */
  double* stress_force;             /* [N/m^3], 3 x cells: -grad p + div tau, the force per volume on what is immersed;
                                       one-sided at walls and baffles; zero where particles feel none (model B) */
  /* for effects; null unless asked for, and only of solvers whose needs say that they can */
  const double* added_viscosity;    /* in [Pa s], cells: beside the molecular viscosity */
  double* flux[3];                  /* out [m/s], faces: eps u, the gas volume per area and time that the mass balance closed with */
} similitude_gas_step;

typedef struct similitude_gas_report {
  uint32_t struct_size;
  int32_t iterations;               /* of the pressure solve */
  double mass_residual;             /* [-], largest cell imbalance of the step relative to the throughput (or the exchange) */
  double inflow, outflow;           /* [kg/s], through patches at the end of the step, both positive */
  double courant;                   /* [-], largest sum over directions of |u| dt / h */
  double momentum[3];               /* [kg m/s], of the gas */
} similitude_gas_report;

/* How a solver differs from model A with inertia. Zero: it does not. */
typedef struct similitude_fluid_needs {
  uint32_t struct_size;
  int32_t drag_over_gas_fraction;   /* 1: model B: particles feel, and the gas is charged, K / eps of the drag law's K */
  int32_t any_courant_number;       /* 1: nothing is advected: the Courant number is reported, but limits no step */
  int32_t takes_added_viscosity;    /* 1: the solver reads added_viscosity */
  int32_t gives_flux;               /* 1: the solver writes flux */
} similitude_fluid_needs;

typedef struct similitude_fluid_functions {
  uint32_t struct_size;
  int32_t sees_particles;           /* 0: a given gas that needs no solids fraction (one-way); 1: coupled */
  /* Called once; the grid stays valid. Fills the initial fields. [setup] */
  void (*initialise)(void* model, const similitude_grid* grid, const similitude_gas_step* fields, similitude_status* status);
  void (*advance)(void* model, const similitude_gas_step* step, similitude_gas_report* report, similitude_status* status);   /* [main] */
  /* [s]: hard stability limits of the explicit parts other than CFL, for the bed given at creation; null: none. [setup] */
  double (*largest_stable_step)(const void* model, const similitude_grid* grid);
  /* State beyond the fields of the step, for checkpoints; null: none. state_size is the same number from initialise on: a new model of
   * the same case loads what another saved. UINT64_MAX, or NaN as the first number saved: it could not be told, and the run ends. [main] */
  uint64_t (*state_size)(const void* model);
  void (*save_state)(const void* model, double* out);
  void (*load_state)(void* model, const double* in);
  void (*needs)(const void* model, similitude_fluid_needs* out);   /* null: all zero. [setup] */
} similitude_fluid_functions;

/* ------------------------------------------------------------------------------------------------------- effect */

/* An effect adds to a bed what its drag and contact laws leave out. It may have any of
 *   a particle pass   force, linear coefficient and added mass of one particle in its gas
 *   a contact pass    force, couple and flows of scalars in one contact, beside the contact law
 *   a cell pass       viscosity added to the gas
 *   scalars           carried by the gas or by the particles, declared as data, with their exchange
 * Fields and passes exist only for effects that a case lists. What one effect adds no other effect sees within a step, so
 * that the order of the list changes sums to rounding and nothing else. */

#define SIMILITUDE_MAX_QUANTITIES 16

/* What a declared quantity is, and which key of a case gives it. */
enum {
  SIMILITUDE_GAS_SCALAR = 0,        /* carried by the gas. gas.NAME: at the start; patches.P.NAME: of what flows in */
  SIMILITUDE_PARTICLE_SCALAR = 1,   /* a column of particles. particles.CLASS.NAME: at the start */
  SIMILITUDE_GAS_PROPERTY = 2,      /* one number. gas.NAME */
  SIMILITUDE_PARTICLE_PROPERTY = 3, /* one number of each class. particles.CLASS.NAME */
  SIMILITUDE_WALL_PROPERTY = 4      /* one number of all walls. walls.NAME; left out, walls give and take nothing */
};

/* Static: case keys, schema and error texts come from it before any model is created. */
typedef struct similitude_quantity {
  uint32_t struct_size;
  int32_t kind;                   /* SIMILITUDE_GAS_SCALAR ... */
  const char* name;               /* lower_snake; the same name, kind and unit in two effects is one quantity */
  const char* unit;               /* "K", "1" for a mass fraction, "J/(kg K)" */
  const char* amount_unit;        /* of scalars: "J", "kg": what mass times capacity times the scalar adds up to; else null */
  const char* doc;                /* one sentence */
  double default_value;           /* NaN: the case must give it (a wall property may stay out) */
  double minimum, maximum;        /* hard */
  int32_t scales_as;              /* SIMILITUDE_SCALES_... */
  int32_t capacity;               /* of a particle scalar: index of the particle property that, times the mass, is its
                                     capacity; -1: the mass itself */
} similitude_quantity;

/* How the gas carries a scalar: d(eps rho capacity s)/dt + div(eps rho capacity u s) = div(eps rho capacity D grad s) + exchange. */
typedef struct similitude_gas_scalar_law {
  uint32_t struct_size;
  uint32_t reserved;
  double capacity;                /* amount per kg of gas and unit of s: heat capacity [J/(kg K)], 1 for mass fractions;
                                     0: another effect that declares the scalar says it */
  double diffusivity;             /* [m^2/s], of the simulated bed */
  double turbulent_number;        /* [-], Pr_t or Sc_t: an added viscosity nu_t adds nu_t / this; 0: it adds nothing */
} similitude_gas_scalar_law;

/* What a particle or contact pass wants to read beyond what it always gets. */
enum {
  SIMILITUDE_READS_ANGULAR_VELOCITY = 1,   /* particles have spin, forces have torques */
  SIMILITUDE_READS_GAS_VORTICITY = 2,      /* curl u at the particle */
  SIMILITUDE_READS_GAS_ACCELERATION = 4    /* Du/Dt at the particle */
};

/* What it adds beyond a force. */
enum {
  SIMILITUDE_ADDS_ADDED_MASS = 1,          /* of the particle pass */
  SIMILITUDE_ADDS_COUPLE = 2,              /* of the contact pass */
  SIMILITUDE_ADDS_FLOW = 4,                /* of particle scalars, of the contact pass */
  SIMILITUDE_ADDS_FLOW_ALONE = 8           /* with it: the contact pass adds no force and is not called for one */
};

typedef struct similitude_effect_needs {
  uint32_t struct_size;
  uint32_t reads;                                   /* SIMILITUDE_READS_... */
  uint32_t adds;                                    /* SIMILITUDE_ADDS_... */
  uint32_t history_count;                           /* of the contact pass, <= SIMILITUDE_MAX_HISTORY */
  int32_t history_parity[SIMILITUDE_MAX_HISTORY];
  const char* history_name[SIMILITUDE_MAX_HISTORY];
  const char* history_unit[SIMILITUDE_MAX_HISTORY];
  const char* partners;                             /* ids of models of any kind that must be there: "a|b c": a or b, and c; or null */
  const char* conflicts;                            /* ids of models that must not be there: "a b"; or null */
} similitude_effect_needs;

typedef struct similitude_range {
  double lowest, mean, highest;     /* NaN where nothing is known */
} similitude_range;

/* What a run saw, over its particles and output intervals; of the real bed. */
typedef struct similitude_occurred {
  uint32_t struct_size;
  uint32_t reserved;
  similitude_range solids_fraction;     /* [-], around particles */
  similitude_range slip_speed;          /* [m/s] */
  similitude_range particle_speed;      /* [m/s] */
  similitude_range angular_speed;       /* [rad/s] */
  similitude_range vorticity;           /* [1/s], |curl u| around particles */
  similitude_range strain_rate;         /* [1/s], sqrt(2 S:S) in cells */
  const similitude_range* value;        /* by quantity; null where the effect declares none */
} similitude_occurred;

/* What an effect may judge by. */
typedef struct similitude_evidence {
  uint32_t struct_size;
  uint32_t reserved;
  const similitude_bed* bed;            /* the real one */
  const double* value;                  /* by quantity, of the particle class that is judged; NaN where the case gives none */
  const double* inflow_value;           /* of scalars: of the inlet, or the other particle class, that differs most; NaN: none */
  const similitude_occurred* occurred;  /* null before a run */
} similitude_evidence;

/* A verdict on whether a scene calls for an effect. */
typedef struct similitude_relevance {
  uint32_t struct_size;
  int32_t verdict;                  /* 1 needed, 0 negligible, -1 cannot tell */
  double value, threshold;          /* of the dimensionless group; NaN where it cannot be told */
  const char* group;                /* "rho_f/rho_p" */
  const char* source;               /* of the threshold */
  double lowest, highest;           /* the range that the value may have in this scene */
  int32_t needed_below;             /* 1: needed where the value is below the threshold */
  int32_t reserved;
  const char* missing;              /* of a verdict that cannot tell: what would tell, e.g. "scene.gas.temperature"; else null */
} similitude_relevance;

/* A block of particles for an effect's pass. Once per gas step; what it adds is held over the step's sub-steps. [worker] */
typedef struct similitude_particle_block {
  uint32_t struct_size;
  uint32_t rows;
  double dt;                            /* [s], gas step */
  const double* diameter;               /* [m], of one physical particle */
  const double* mass;                   /* [kg], of one physical particle */
  const double* velocity[3];            /* [m/s] */
  const double* gas_velocity[3];        /* [m/s], at the particle */
  const double* gas_fraction;           /* [-] */
  const double* gas_density;            /* [kg/m^3] */
  const double* gas_viscosity;          /* [Pa s], molecular */
  const double* angular_velocity[3];    /* [rad/s]; this and the next two null unless read */
  const double* gas_vorticity[3];       /* [1/s] */
  const double* gas_acceleration[3];    /* [m/s^2], Du/Dt */
  double* force[3];                     /* add [N]: on one physical particle; the gas receives the opposite */
  double* linear_coefficient;           /* add [kg/s]: F = c (u - v), treated implicitly */
  double* added_mass;                   /* add [kg]: m_a of a force m_a (Du/Dt - dv/dt); m_a Du/Dt belongs into `force`, the rest
                                           is the integrator's; null unless added */
} similitude_particle_block;

/* A block of contacts after the contact law, walls included (similitude_contact_block says what they are). Rows may be
 * contacts within the effect's reach that the law does not know: their law_force is zero. [worker] */
typedef struct similitude_contact_effect_block {
  uint32_t struct_size;
  uint32_t rows;
  double dt;                            /* [s], sub-step */
  const double* normal[3];              /* [-], from j toward i */
  const double* overlap;                /* [m] */
  const double* velocity[3];            /* [m/s], of i relative to j at the contact point */
  const double* angular_velocity_i[3];  /* [rad/s]; null without rotation */
  const double* angular_velocity_j[3];
  const double* radius_i;               /* [m] */
  const double* radius_j;               /* [m], infinite for a flat wall */
  const double* effective_mass;         /* [kg] */
  const double* law_force[3];           /* [N], on i, of the contact law alone */
  const double* const* value_i;         /* by quantity: particle scalars and properties; null where there is none of the kind */
  const double* const* value_j;         /* of a wall: the wall property of the same name, NaN if not given */
  double* history[SIMILITUDE_MAX_HISTORY];   /* in and out; zero in the first step of a contact */
  double* force[3];                     /* add [N], on i; j receives the opposite */
  double* couple[3];                    /* add [N m], on i; null unless added */
  double* const* flow;                  /* out, by quantity of particle scalars: amount per second from j into i; null in calls for forces.
                                           Flows are asked for in calls of their own, once per gas step with its dt, without
                                           history, force and couple */
} similitude_contact_effect_block;

/* A block of cells. Once per gas step, before the gas. [worker] */
typedef struct similitude_cell_block {
  uint32_t struct_size;
  uint32_t rows;
  const double* gas_fraction;           /* [-] */
  const double* gas_density;            /* [kg/m^3] */
  const double* gas_viscosity;          /* [Pa s], molecular */
  const double* strain_rate;            /* [1/s], sqrt(2 S:S), S of the gas's velocity */
  const double* cell_size;              /* [m], cube root of the cell's volume */
  double* added_viscosity;              /* add [Pa s] */
} similitude_cell_block;

/* Exchange of scalars of ONE physical particle with its gas: amount per second into the particle = coefficient (s_gas - level),
 * implicit in s_gas at the end of the step. An effect that relaxes its own particle scalar puts the implicitness of that into the
 * coefficient, c / (1 + c dt / C). Filled twice per gas step: exchange() before the gas's scalars advance, take() after. [worker] */
typedef struct similitude_scalar_block {
  uint32_t struct_size;
  uint32_t rows;
  double dt;                            /* [s], gas step */
  const double* diameter;               /* [m], of one physical particle */
  const double* mass;                   /* [kg], of one physical particle */
  const double* gas_fraction;           /* [-] */
  const double* slip_speed;             /* [m/s] */
  const double* gas_density;            /* [kg/m^3] */
  const double* gas_viscosity;          /* [Pa s] */
  const double* const* value;           /* by quantity: gas scalars at the particle, particle properties; null for others */
  double* const* particle;              /* by quantity: particle scalars; in of exchange(), in and out of take() */
  double* const* coefficient;           /* by quantity: out of exchange(), gas scalars */
  double* const* level;                 /* out of exchange() */
  const double* const* received;        /* in of take(): amount that one physical particle received in this step */
} similitude_scalar_block;

/* All hooks but `relevance` may be null. */
typedef struct similitude_effect_functions {
  uint32_t struct_size;
  uint32_t quantity_count;                                  /* <= SIMILITUDE_MAX_QUANTITIES */
  const similitude_quantity* quantities;                    /* "by quantity" above: in the order of this list */
  void (*relevance)(const void* model, const similitude_evidence* evidence, similitude_relevance* out);   /* [setup][main] */
  void (*needs)(const void* model, similitude_effect_needs* out);   /* null: all zero. [setup] */
  int32_t (*uses)(const void* model, uint32_t quantity);    /* 0: not with these parameters; null: all are used. [setup] */
  /* Once, with gas and wall properties by quantity (NaN elsewhere and where not given), before any pass. [setup] */
  void (*configure)(void* model, const double* properties, similitude_gas_scalar_law* laws, similitude_status* status);
  void (*particles)(const void* model, const similitude_particle_block* block, similitude_status* status);      /* [worker] */
  void (*contacts)(const void* model, const similitude_contact_effect_block* block, similitude_status* status); /* [worker] */
  double (*reach)(const void* model, double diameter);      /* [m], contacts begin at this gap; null: at touch. [setup] */
  /* [s], beyond it the explicit step of the contact pass is unstable; null or infinite: none. [setup] */
  double (*largest_stable_step)(const void* model, double effective_mass, double effective_radius, double speed);
  void (*cells)(const void* model, const similitude_cell_block* block, similitude_status* status);              /* [worker] */
  void (*exchange)(const void* model, const similitude_scalar_block* block, similitude_status* status);         /* [worker] */
  void (*take)(const void* model, const similitude_scalar_block* block, similitude_status* status);             /* [worker] */
} similitude_effect_functions;

#ifdef __cplusplus
}
#endif
#endif
