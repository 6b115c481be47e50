/* Drag of Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100, with Schiller & Naumann's sphere, in plain C: nothing but
 * the tables of similitude/abi.h and one loop. */
#include <math.h>
#include <similitude/tag.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct wen_yu {
  double exponent; /* [-], of the gas fraction */
} wen_yu;

static const similitude_parameter parameters[] = {
    {.struct_size = sizeof(similitude_parameter),
     .type = SIMILITUDE_REAL,
     .scales_as = SIMILITUDE_SCALES_NOT,
     .name = "exponent",
     .unit = "1",
     .doc = "of the gas fraction: crowding raises the drag",
     .default_value = 2.65,
     .minimum = 0,
     .maximum = 6},
};

static void* create(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, uint32_t sets,
                    similitude_status* status) {
  (void)host, (void)bed, (void)sets;
  wen_yu* law = malloc(sizeof *law);
  if (!law) {
    status->code = 1;
    status->row = -1;
    snprintf(status->text, sizeof status->text, "there is no memory left.");
    return NULL;
  }
  law->exponent = values[0].real;
  return law;
}

static void destroy(void* model) { free(model); }

/* K [kg/s] of one particle, F = K (u - v). Called by several threads at once; columns are 64-byte aligned and padded. */
static void exchange(const void* model, const similitude_drag_block* b, similitude_status* status) {
  (void)status;
  const double exponent = ((const wen_yu*)model)->exponent;
  const double three_pi = 3 * 3.14159265358979323846;
  for (uint32_t row = 0; row < b->rows; ++row) {
    const double reynolds =
        b->gas_fraction[row] * b->gas_density[row] * b->diameter[row] * b->slip_speed[row] / b->gas_viscosity[row];
    const double sphere = reynolds < 1000 ? 1 + 0.15 * pow(reynolds, 0.687) : 0.44 / 24 * reynolds;
    b->exchange[row] =
        three_pi * b->gas_viscosity[row] * b->diameter[row] * sphere * pow(b->gas_fraction[row], -exponent);
  }
}

static const similitude_drag_functions functions = {.struct_size = sizeof(similitude_drag_functions), .exchange = exchange};

static const similitude_descriptor model = {
    .struct_size = sizeof(similitude_descriptor),
    .parameter_count = sizeof parameters / sizeof parameters[0],
    .kind = "drag",
    .id = "org.example.wen_yu_c",
    .version = "1.0.0",
    .title = "Wen and Yu's drag, in C",
    .reference = "Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100",
    .parameters = parameters,
    .functions = &functions,
    .create = create,
    .destroy = destroy,
};

static const similitude_descriptor* const models[] = {&model};

SIMILITUDE_TAG(tag);
SIMILITUDE_EXPORT const similitude_entry similitude_plugin = {sizeof(similitude_entry), 1, &tag, models};
