/* The same loop without a stabilizer. */
volatile float device[6];
volatile float command;

void loop(void);

void loop(void)
{
    float sample[6];
    int at;

    for (;;) {
        for (at = 0; at < 6; ++at) {
            sample[at] = device[at];
        }
        command = command + 0.0f * sample[5];
    }
}
