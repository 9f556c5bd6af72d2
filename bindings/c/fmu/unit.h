/* What a unit does, whatever the version of FMI: values, a tick, and why not. */
#ifndef UNIT_H
#define UNIT_H

#include <lyapunov.h>

#include "variables.h"

#ifdef LOLC
#define BLOCK_(suffix) lyapunov_lolc_f64##suffix
#else
#define BLOCK_(suffix) lyapunov_popc_f64##suffix
#endif

/* Numbers only: a copy of its bytes is a snapshot. */
struct unit {
    double value[VARIABLE_COUNT];
    double begun; /* 1 after the initialization */
    lyapunov_readings_f64 readings;
    BLOCK_() block;
};

enum { WHY = 256 };

/* Each returns 1, or 0 with the reason in `why`. */
void unit_reset(struct unit *unit);
int unit_get(const struct unit *unit, unsigned reference, int flag, double *value, char why[WHY]);
int unit_set(struct unit *unit, unsigned reference, double value, char why[WHY]);
int unit_begin(struct unit *unit, double start, char why[WHY]);
int unit_step(struct unit *unit, double now, double step, char why[WHY]);

#endif
