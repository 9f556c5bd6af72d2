/* LOLC with a candidate of your own: the port's energy, credited with what quadratic drag must have burnt. */
#include <stdio.h>

#include <lyapunov.h>

struct drag {
    float coefficient; /* N.s^2/m^2 */
};

/* The decrease over the sample, J. */
static float decrease(void *context, const lyapunov_sample_f32 *sample)
{
    const struct drag *drag = context;
    float speed = sample->velocity < 0.0f ? -sample->velocity : sample->velocity;

    return sample->work + drag->coefficient * speed * speed * speed * sample->period;
}

int main(void)
{
    struct drag drag = { 0.5f };
    lyapunov_lolc_custom_f32 lolc;
    lyapunov_lolc_custom_f32_parameters parameters = { 0.0f, 0.0f };
    lyapunov_sample_f32 sample = { 1e-3f, 0.0f, 0.1f, 1e-4f, -2.0f, -2e-4f }; /* gave 0.2 mJ */
    lyapunov_correction_f32 correction;
    lyapunov_status status = lyapunov_damping_limit_f32_of_mass(0.5f, 0.2f, 1e-3f, 0, &parameters.damping_limit);

    if (status.code == LYAPUNOV_OK) {
        status = lyapunov_lolc_custom_f32_init(&lolc, &parameters);
    }
    if (status.code != LYAPUNOV_OK) {
        return 1;
    }
    lyapunov_lolc_custom_f32_step(&lolc, &sample, 0.5f, decrease, &drag, &correction);
    printf("observed energy %g J, damping %g N.s/m, effort %g N\n", (double)correction.observed_energy,
           (double)correction.alpha, (double)correction.effort);
    return correction.observed_energy < 0.0f && correction.effort > 0.5f ? 0 : 1;
}
