/* The functions of FMI 2.0 for co-simulation. */
#include <stdlib.h>

#include <fmi2Functions.h>

#include "instance.h"

static fmi2Status status(int done)
{
    return done ? fmi2OK : fmi2Error;
}

static void tell(struct instance *instance, const char *why)
{
    const fmi2CallbackFunctions *functions = instance->environment;

    if (functions->logger) {
        functions->logger(functions->componentEnvironment, instance->name, fmi2Error, "logStatusError", "%s", why);
    }
}

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component unit, fmi2Boolean on, size_t count, const fmi2String categories[])
{
    (void)unit, (void)on, (void)count, (void)categories;
    return fmi2OK; /* only errors are told, and always */
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean logging)
{
    struct instance *instance = type == fmi2CoSimulation && functions ? instance_new(name, token) : NULL;

    (void)resources, (void)visible, (void)logging;
    if (instance) {
        instance->environment = (void *)functions;
        instance->tell = tell;
    }
    return instance;
}

void fmi2FreeInstance(fmi2Component unit)
{
    instance_free(unit);
}

fmi2Status fmi2SetupExperiment(fmi2Component unit, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean has_stop, fmi2Real stop)
{
    struct instance *of = unit;

    (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
    of->unit.value[VARIABLE_time] = start;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component unit)
{
    (void)unit;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component unit)
{
    struct instance *of = unit;
    char why[WHY];

    return status(instance_done(of, unit_begin(&of->unit, of->unit.value[VARIABLE_time], why), why));
}

fmi2Status fmi2Terminate(fmi2Component unit)
{
    (void)unit;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component unit)
{
    unit_reset(&((struct instance *)unit)->unit);
    return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count, fmi2Real values[])
{
    return status(instance_get(unit, references, count, 0, values));
}

fmi2Status fmi2SetReal(fmi2Component unit, const fmi2ValueReference references[], size_t count, const fmi2Real values[])
{
    return status(instance_set(unit, references, count, values));
}

fmi2Status fmi2GetBoolean(fmi2Component unit, const fmi2ValueReference references[], size_t count, fmi2Boolean values[])
{
    size_t at;
    double value;

    for (at = 0; at < count; ++at) {
        if (!instance_get(unit, &references[at], 1, 1, &value)) {
            return fmi2Error;
        }
        values[at] = value != 0.0;
    }
    return fmi2OK;
}

fmi2Status fmi2GetFMUstate(fmi2Component unit, fmi2FMUstate *state)
{
    return status(instance_save(unit, state));
}

fmi2Status fmi2SetFMUstate(fmi2Component unit, fmi2FMUstate state)
{
    return status(instance_restore(unit, state));
}

fmi2Status fmi2FreeFMUstate(fmi2Component unit, fmi2FMUstate *state)
{
    (void)unit;
    free(*state);
    *state = NULL;
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component unit, fmi2FMUstate state, size_t *size)
{
    (void)unit, (void)state;
    *size = sizeof(struct unit);
    return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component unit, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    return status(instance_serialize(unit, state, bytes, size));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component unit, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    return status(instance_deserialize(unit, bytes, size, state));
}

fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real now, fmi2Real step, fmi2Boolean no_return)
{
    struct instance *of = unit;
    char why[WHY];

    (void)no_return;
    return status(instance_done(of, unit_step(&of->unit, now, step, why), why));
}
