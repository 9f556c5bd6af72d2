/* A stabilizer behind its readings, as a unit of numbered values. */
#include "unit.h"

#include <stdio.h>
#include <string.h>

#define NAME(name, kind, start, unit, description) #name,
#define KIND(name, kind, start, unit, description) kind,
#define START(name, kind, start, unit, description) start,

static const char *const names[] = { VARIABLES(NAME) };
static const enum kind kinds[] = { VARIABLES(KIND) };
static const double starts[] = { VARIABLES(START) };

void unit_reset(struct unit *unit)
{
    memset(unit, 0, sizeof *unit);
    memcpy(unit->value, starts, sizeof starts);
}

int unit_get(const struct unit *unit, unsigned reference, int flag, double *value, char why[WHY])
{
    if (reference >= VARIABLE_COUNT || (kinds[reference] == FLAG) != (flag != 0)) {
        snprintf(why, WHY, "value reference %u is no variable of this type; see modelDescription.xml", reference);
        return 0;
    }
    /* Before the block is made it has what it will be made with. */
    if (reference == VARIABLE_observed_energy && unit->begun == 0.0) {
        reference = VARIABLE_budget;
    }
    *value = unit->value[reference];
    return 1;
}

int unit_set(struct unit *unit, unsigned reference, double value, char why[WHY])
{
    if (reference >= VARIABLE_COUNT || (kinds[reference] != INPUT && kinds[reference] != PARAMETER)) {
        snprintf(why, WHY, "value reference %u is neither an input nor a parameter; see modelDescription.xml", reference);
        return 0;
    }
    if (kinds[reference] == PARAMETER && unit->begun != 0.0) {
        snprintf(why, WHY, "%s is a parameter; set it before the initialization ends", names[reference]);
        return 0;
    }
    unit->value[reference] = value;
    return 1;
}

static int accepted(lyapunov_status status, char why[WHY])
{
    if (status.code != LYAPUNOV_OK) {
        lyapunov_status_text(&status, why, WHY);
    }
    return status.code == LYAPUNOV_OK;
}

int unit_begin(struct unit *unit, double start, char why[WHY])
{
    lyapunov_readings_f64_parameters told;
    BLOCK_(_parameters) parameters;

    told.period = unit->value[VARIABLE_period];
    told.fastest = unit->value[VARIABLE_fastest];
    parameters.damping_limit = unit->value[VARIABLE_damping_limit];
#ifdef LOLC
    parameters.device_damping = unit->value[VARIABLE_device_damping];
#endif
    parameters.budget = unit->value[VARIABLE_budget];
    if (!accepted(lyapunov_readings_f64_init(&unit->readings, &told), why) ||
        !accepted(BLOCK_(_init)(&unit->block, &parameters), why)) {
        return 0;
    }
    unit->value[VARIABLE_time] = start;
    unit->value[VARIABLE_observed_energy] = BLOCK_(_observed_energy)(&unit->block);
    unit->begun = 1.0;
    return 1;
}

int unit_step(struct unit *unit, double now, double step, char why[WHY])
{
    double *value = unit->value;
    double period = value[VARIABLE_period], off = step - period;
    lyapunov_checked_sample_f64 read;
    lyapunov_correction_f64 correction;

    /* The difference of two times is the period but for their rounding. */
    if (!(off <= 1e-6 * period && -off <= 1e-6 * period)) {
        snprintf(why, WHY, "the communication step size is %g s; it must be the parameter period, %g s", step, period);
        return 0;
    }
    if (lyapunov_readings_f64_read(&unit->readings, value[VARIABLE_position], value[VARIABLE_applied], &read) != LYAPUNOV_OK ||
        BLOCK_(_step)(&unit->block, &read.sample, value[VARIABLE_effort], &correction) != LYAPUNOV_OK) {
        snprintf(why, WHY, "the unit is not initialized; leave the initialization before the first step");
        return 0;
    }
    value[VARIABLE_time] = now + step;
    value[VARIABLE_command] = correction.effort;
    value[VARIABLE_observed_energy] = correction.observed_energy;
    value[VARIABLE_alpha] = correction.alpha;
    value[VARIABLE_shortfall] = correction.shortfall;
    value[VARIABLE_accepted] = correction.accepted;
    return 1;
}
