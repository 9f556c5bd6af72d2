/* The first example of the README: readings, POPC in a compensated sum, and its damping limit.
 * With CONSTANT_LIMIT the limit is a number; with TEXT a refusal is put into words. */
#include <lyapunov.h>

static lyapunov_readings_f32 readings;
static lyapunov_lolc_compensated_f32 popc;
volatile float device[2];
volatile float command;

void loop(void);

#ifdef TEXT
volatile char out;

static void report(const char *text)
{
    while (*text) {
        out = *text++;
    }
}
#endif

static int start(void)
{
    lyapunov_readings_f32_parameters told = { 1e-3f, 2.0f };
    lyapunov_lolc_compensated_f32_parameters parameters = { { 100.0f, 0.0f, 0.0f } };
    lyapunov_status status;

#ifdef CONSTANT_LIMIT
    status = lyapunov_lolc_compensated_f32_init(&popc, &parameters);
#else
    status = lyapunov_damping_limit_f32_of_mass(0.5f, 0.2f, 1e-3f, 0, &parameters.lolc.damping_limit);
    if (status.code == LYAPUNOV_OK) status = lyapunov_lolc_compensated_f32_init(&popc, &parameters);
#endif
    if (status.code == LYAPUNOV_OK) status = lyapunov_readings_f32_init(&readings, &told);
#ifdef TEXT
    if (status.code != LYAPUNOV_OK) {
        char text[160];
        lyapunov_status_text(&status, text, sizeof text);
        report(text);
    }
#endif
    return status.code == LYAPUNOV_OK;
}

static float wall(float position)
{
    return position > 0.0f ? 8000.0f * position : 0.0f;
}

static float tick(float position, float applied)
{
    lyapunov_checked_sample_f32 read;
    lyapunov_correction_f32 correction;

    lyapunov_readings_f32_read(&readings, position, applied, &read);
    lyapunov_lolc_compensated_f32_step(&popc, &read.sample, wall(read.sample.position), &correction);
    return correction.effort;
}

void loop(void)
{
    if (!start()) {
        return;
    }
    for (;;) {
        command = tick(device[0], device[1]);
    }
}
