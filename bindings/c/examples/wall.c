/* Virtual wall that is too stiff for its sampling rate, alone and with the passivity observer/controller. */
#include <stdio.h>

#include <lyapunov.h>

enum { TICKS = 3000 };

static const double period = 1e-2;     /* s: a slow loop */
static const double mass = 0.3;        /* kg */
static const double stiffness = 50000; /* N/m, far more than this mass bears at 100 Hz */

/* Where the mass is a period later, under a held force and a spring of 50 N/m that pulls it to the wall's surface. */
static void move(double *position, double *velocity, double force)
{
    int part;

    for (part = 0; part < 100; ++part) {
        *velocity += (-50.0 * *position - 0.2 * *velocity - force) / mass * (period / 100);
        *position += *velocity * (period / 100);
    }
}

/* The largest swing in the last ten seconds, m; below 0 if a block was refused. */
static double late_swing(int stabilized)
{
    lyapunov_readings_f64 readings;
    lyapunov_readings_f64_parameters told;
    lyapunov_popc_f64 popc;
    lyapunov_popc_f64_parameters parameters = { 0.0, 0.0 };
    lyapunov_checked_sample_f64 read;
    lyapunov_correction_f64 correction;
    lyapunov_status status;
    double position = -4e-3, velocity = 0.0, applied = 0.0, swing = 0.0;
    int tick;

    told.period = period;
    told.fastest = 1e300; /* no limit here: without the stabilizer the mass goes anywhere */
    status = lyapunov_readings_f64_init(&readings, &told);
    if (status.code == LYAPUNOV_OK) {
        status = lyapunov_damping_limit_f64_of_mass(0.5, mass, period, 0, &parameters.damping_limit);
    }
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
        double wall;

        /* Your loop: what the device tells, your controller, the correction, the motor. */
        lyapunov_readings_f64_read(&readings, position, applied, &read);
        wall = read.sample.position > 0.0 ? stiffness * read.sample.position : 0.0;
        if (lyapunov_popc_f64_step(&popc, &read.sample, wall, &correction) != LYAPUNOV_OK) {
            return -1.0;
        }
        applied = stabilized ? correction.effort : wall;

        /* Your device. */
        move(&position, &velocity, applied);
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
    return stabilized >= 0.0 && stabilized < 4e-3 && alone > 10.0 * stabilized ? 0 : 1;
}
