/* The functions of FMI 3.0 for co-simulation. */
#include <stdlib.h>

#include <fmi3Functions.h>

#include "instance.h"

static fmi3Status status(int done)
{
    return done ? fmi3OK : fmi3Error;
}

static void tell(struct instance *instance, const char *why)
{
    fmi3LogMessageCallback log = (fmi3LogMessageCallback)instance->logger;

    if (log) {
        log(instance->environment, fmi3Error, "logStatusError", why);
    }
}

const char *fmi3GetVersion(void)
{
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t count, const fmi3String categories[])
{
    (void)instance, (void)on, (void)count, (void)categories;
    return fmi3OK; /* only errors are told, and always */
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean events, fmi3Boolean early,
                                         const fmi3ValueReference required[], size_t required_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update)
{
    struct instance *instance = instance_new(name, token);

    (void)resources, (void)visible, (void)logging, (void)events, (void)early;
    (void)required, (void)required_count, (void)update;
    if (!instance) {
        if (log) {
            log(environment, fmi3Error, "logStatusError", "the instantiation token is not " TOKEN ", or there is no memory");
        }
        return NULL;
    }
    instance->environment = environment;
    instance->logger = (void (*)(void))log;
    instance->tell = tell;
    return instance;
}

void fmi3FreeInstance(fmi3Instance instance)
{
    instance_free(instance);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop)
{
    struct instance *of = instance;

    (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
    of->unit.value[VARIABLE_time] = start;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
    struct instance *of = instance;
    char why[WHY];

    return status(instance_done(of, unit_begin(&of->unit, of->unit.value[VARIABLE_time], why), why));
}

fmi3Status fmi3Terminate(fmi3Instance instance)
{
    (void)instance;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance instance)
{
    unit_reset(&((struct instance *)instance)->unit);
    return fmi3OK;
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3Float64 values[],
                          size_t value_count)
{
    return status(instance_done(instance, count == value_count, "as many values as references") &&
                  instance_get(instance, references, count, 0, values));
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t value_count)
{
    return status(instance_done(instance, count == value_count, "as many values as references") &&
                  instance_set(instance, references, count, values));
}

fmi3Status fmi3GetBoolean(fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3Boolean values[],
                          size_t value_count)
{
    size_t at;
    double value;

    if (!instance_done(instance, count == value_count, "as many values as references")) {
        return fmi3Error;
    }
    for (at = 0; at < count; ++at) {
        if (!instance_get(instance, &references[at], 1, 1, &value)) {
            return fmi3Error;
        }
        values[at] = value != 0.0;
    }
    return fmi3OK;
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *state)
{
    return status(instance_save(instance, state));
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state)
{
    return status(instance_restore(instance, state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *state)
{
    (void)instance;
    free(*state);
    *state = NULL;
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, size_t *size)
{
    (void)instance, (void)state;
    *size = sizeof(struct unit);
    return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    return status(instance_serialize(instance, state, bytes, size));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState *state)
{
    return status(instance_deserialize(instance, bytes, size, state));
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 now, fmi3Float64 step, fmi3Boolean no_return,
                      fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *last)
{
    struct instance *of = instance;
    char why[WHY];
    int done = instance_done(of, unit_step(&of->unit, now, step, why), why);

    (void)no_return;
    *event = *terminate = *early = fmi3False;
    *last = done ? now + step : now;
    return status(done);
}
