/* The tables of similitude/abi.h around a formula in Fortran (wen_yu.f90): Fortran cannot fill a table with addresses before
 * the program starts, C can. */
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

/* In wen_yu.f90. */
void wen_yu_exchange(int32_t rows, double exponent, const double* diameter, const double* gas_fraction,
                     const double* slip_speed, const double* gas_density, const double* gas_viscosity, double* exchange);

static void exchange(const void* model, const similitude_drag_block* b, similitude_status* status) {
  (void)status;
  wen_yu_exchange((int32_t)b->rows, ((const wen_yu*)model)->exponent, b->diameter, b->gas_fraction, b->slip_speed,
                  b->gas_density, b->gas_viscosity, b->exchange);
}

static const similitude_drag_functions functions = {.struct_size = sizeof(similitude_drag_functions), .exchange = exchange};

static const similitude_descriptor model = {
    .struct_size = sizeof(similitude_descriptor),
    .parameter_count = sizeof parameters / sizeof parameters[0],
    .kind = "drag",
    .id = "org.example.wen_yu_fortran",
    .version = "1.0.0",
    .title = "Wen and Yu's drag, in Fortran",
    .reference = "Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100",
    .parameters = parameters,
    .functions = &functions,
    .create = create,
    .destroy = destroy,
};

static const similitude_descriptor* const models[] = {&model};

SIMILITUDE_TAG(tag);
SIMILITUDE_EXPORT const similitude_entry similitude_plugin = {sizeof(similitude_entry), 1, &tag, models};
