/* One POPC in float, and nothing else: what the library takes in flash and memory. */
#include <lyapunov.h>

lyapunov_popc_f32 popc;
static const lyapunov_popc_f32_parameters parameters = { 80.0f, 0.0f };
volatile lyapunov_sample_f32 device;
volatile float command;

void loop(void);

void loop(void)
{
    lyapunov_correction_f32 correction;
    lyapunov_sample_f32 sample;

    if (lyapunov_popc_f32_init(&popc, &parameters).code != LYAPUNOV_OK) {
        return;
    }
    for (;;) {
        sample = device;
        lyapunov_popc_f32_step(&popc, &sample, command, &correction);
        command = correction.effort;
    }
}
