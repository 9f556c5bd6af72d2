/* Virtual wall that is too stiff for its sampling rate, alone and with the passivity observer/controller. */
#include <stdio.h>

#include <lyapunov.h>

enum { TICKS = 5000 };

static const double period = 1e-3;      /* s */
static const double mass = 0.2;         /* kg */
static const double stiffness = 300000; /* N/m, five times what the loop bears without help */

/* The largest swing in the last second, m. Returns below 0 if the block was refused. */
static double late_swing(int stabilized)
{
    lyapunov_popc_f64 popc;
    lyapunov_popc_f64_parameters parameters = { 0.0, 0.0 };
    lyapunov_sample_f64 sample = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    lyapunov_correction_f64 correction;
    lyapunov_status status;
    double position = -4e-3, velocity = 0.0, applied = 0.0, swing = 0.0;
    int tick;

    status = lyapunov_damping_limit_f64_of_mass(0.5, mass, period, 0, &parameters.damping_limit);
    if (status.code == LYAPUNOV_OK) {
        status = lyapunov_popc_f64_init(&popc, &parameters);
    }
    if (status.code != LYAPUNOV_OK) {
        char text[160];
        lyapunov_status_text(&status, text, sizeof text);
        fprintf(stderr, "%s\n", text);
        return -1.0;
    }
    for (tick = 0; tick < TICKS; ++tick) {
        double hand = -50.0 * position; /* a spring to the wall's surface */
        double wall, before = position;

        /* Your device: it moves by one period under the effort that the motor applied. */
        velocity += (hand - 0.2 * velocity - applied) / mass * period;
        position += velocity * period;

        /* Your loop: a sample, your controller, the correction, the motor. */
        sample.period = period;
        sample.position = position;
        sample.displacement = position - before;
        sample.velocity = sample.displacement / period;
        sample.applied = applied;
        sample.work = applied * sample.displacement;
        wall = position > 0.0 ? stiffness * position : 0.0;
        if (lyapunov_popc_f64_step(&popc, &sample, wall, &correction) != LYAPUNOV_OK) {
            return -1.0;
        }
        applied = stabilized ? correction.effort : wall;
        if (tick >= TICKS - 1000) {
            double size = position < 0.0 ? -position : position;
            swing = size > swing ? size : swing;
        }
    }
    return swing;
}

int main(void)
{
    double alone = late_swing(0), stabilized = late_swing(1);

    printf("late swing alone      %10.4g m\n", alone);
    printf("late swing with POPC  %10.4g m\n", stabilized);
    return stabilized >= 0.0 && stabilized < 4e-3 && alone > stabilized ? 0 : 1;
}
