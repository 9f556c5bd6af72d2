/* The variables of a unit, once: its source and its description are made of this table.
 *
 * Compiled with -DLOLC the unit is LOLC, else POPC. VARIABLE(name, kind, start, unit, description); the place in the table is
 * the value reference. */
#ifndef VARIABLES_H
#define VARIABLES_H

#ifdef LOLC
#define BLOCK "lolc"
#define IDENTIFIER "lyapunov_lolc"
#define DESCRIPTION "Lyapunov observer/controller: damps when the energy at a port was generated, beyond what the device burns"
#define IF_LOLC(variable) variable
#else
#define BLOCK "popc"
#define IDENTIFIER "lyapunov_popc"
#define DESCRIPTION "Passivity observer/controller: damps when the energy at a port was generated"
#define IF_LOLC(variable)
#endif

/* Another number of variables, or another order, needs another token. */
#define TOKEN IDENTIFIER "-1"

#define VARIABLES(VARIABLE) \
    VARIABLE(time, INDEPENDENT, 0.0, "s", "Time") \
    VARIABLE(period, PARAMETER, 1e-3, "s", "The period, which is the communication step size") \
    VARIABLE(fastest, PARAMETER, 1e300, "m/s", "The fastest motion: a reading that is farther away is rejected") \
    VARIABLE(damping_limit, PARAMETER, 0.0, "N.s/m", "Largest damping that is injected; 0 only observes") \
    IF_LOLC(VARIABLE(device_damping, PARAMETER, 0.0, "N.s/m", "Damping that the device surely has")) \
    VARIABLE(budget, PARAMETER, 0.0, "J", "Energy stored in the loop at the start, which may come back") \
    VARIABLE(position, INPUT, 0.0, "m", "Position of the device now") \
    VARIABLE(applied, INPUT, 0.0, "N", "Effort that acted since the last step, against the motion") \
    VARIABLE(effort, INPUT, 0.0, "N", "Effort that the controller asks for, against the motion") \
    VARIABLE(command, OUTPUT, 0.0, "N", "Effort to command, correction included, against the motion") \
    VARIABLE(observed_energy, OUTPUT, 0.0, "J", "Observed energy before this step's correction") \
    VARIABLE(alpha, OUTPUT, 0.0, "N.s/m", "Damping injected on this step") \
    VARIABLE(shortfall, OUTPUT, 0.0, "J", "Part of the debt that this step's correction cannot serve") \
    VARIABLE(accepted, FLAG, 0.0, "", "Whether the reading was accepted; else the command is 0")

enum kind { INDEPENDENT, PARAMETER, INPUT, OUTPUT, FLAG };

#define PLACE(name, kind, start, unit, description) VARIABLE_##name,
enum { VARIABLES(PLACE) VARIABLE_COUNT };
#undef PLACE

#endif
