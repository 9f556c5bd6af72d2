/* The same loop around a POPC by hand: the paper's steps with a period and a limit, without a check of what comes in. */
struct sample {
    float period, position, velocity, displacement, applied, work;
};

struct popc {
    float sum, limit;
};

struct popc popc;
volatile struct sample device;
volatile float command;

void loop(void);

static float __attribute__((noinline)) step(struct popc *state, const struct sample *sample, float effort)
{
    float square = sample->velocity * sample->velocity * sample->period, alpha = 0.0f;

    state->sum += sample->work;
    if (state->sum < 0.0f && square > 1.2e-38f) {
        alpha = -state->sum / square;
        alpha = alpha < state->limit ? alpha : state->limit;
    }
    return effort + alpha * sample->velocity;
}

void loop(void)
{
    struct sample sample;

    popc.limit = 80.0f;
    for (;;) {
        sample.period = device.period;
        sample.position = device.position;
        sample.velocity = device.velocity;
        sample.displacement = device.displacement;
        sample.applied = device.applied;
        sample.work = device.work;
        command = step(&popc, &sample, command);
    }
}
