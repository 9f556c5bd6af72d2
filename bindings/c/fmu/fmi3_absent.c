/* The functions of FMI 3.0 that these units have no use for: importers look them up, and are told so. */
#include <fmi3Functions.h>

#include "instance.h"

#define ABSENT(name, ...)                                            \
    fmi3Status name(fmi3Instance of, __VA_ARGS__)                    \
    {                                                                \
        instance_done(of, 0, #name " is not here: the unit has Float64 and Boolean variables without clocks"); \
        return fmi3Error;                                            \
    }
#define ABSENT_MODE(name)                                            \
    fmi3Status name(fmi3Instance of)                                 \
    {                                                                \
        instance_done(of, 0, #name " is not here: the unit has neither events nor structure"); \
        return fmi3Error;                                            \
    }
#define REFERENCES const fmi3ValueReference references[], size_t count
#define ABSENT_TYPE(type)                                            \
    ABSENT(fmi3Get##type, REFERENCES, fmi3##type values[], size_t value_count) \
    ABSENT(fmi3Set##type, REFERENCES, const fmi3##type values[], size_t value_count)

ABSENT_TYPE(Float32)
ABSENT_TYPE(Int8)
ABSENT_TYPE(UInt8)
ABSENT_TYPE(Int16)
ABSENT_TYPE(UInt16)
ABSENT_TYPE(Int32)
ABSENT_TYPE(UInt32)
ABSENT_TYPE(Int64)
ABSENT_TYPE(UInt64)
ABSENT_TYPE(String)
ABSENT(fmi3SetBoolean, REFERENCES, const fmi3Boolean values[], size_t value_count)
ABSENT(fmi3GetBinary, REFERENCES, size_t sizes[], fmi3Binary values[], size_t value_count)
ABSENT(fmi3SetBinary, REFERENCES, const size_t sizes[], const fmi3Binary values[], size_t value_count)
ABSENT(fmi3GetClock, REFERENCES, fmi3Clock values[])
ABSENT(fmi3SetClock, REFERENCES, const fmi3Clock values[])
ABSENT(fmi3GetNumberOfVariableDependencies, fmi3ValueReference reference, size_t *dependencies)
ABSENT(fmi3GetVariableDependencies, fmi3ValueReference dependent, size_t elements[], fmi3ValueReference independents[],
       size_t independent_elements[], fmi3DependencyKind kinds[], size_t count)
ABSENT(fmi3GetDirectionalDerivative, REFERENCES, const fmi3ValueReference knowns[], size_t known_count,
       const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[], size_t sensitivity_count)
ABSENT(fmi3GetAdjointDerivative, REFERENCES, const fmi3ValueReference knowns[], size_t known_count,
       const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[], size_t sensitivity_count)
ABSENT(fmi3GetIntervalDecimal, REFERENCES, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
ABSENT(fmi3GetIntervalFraction, REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
ABSENT(fmi3GetShiftDecimal, REFERENCES, fmi3Float64 shifts[])
ABSENT(fmi3GetShiftFraction, REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
ABSENT(fmi3SetIntervalDecimal, REFERENCES, const fmi3Float64 intervals[])
ABSENT(fmi3SetIntervalFraction, REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
ABSENT(fmi3SetShiftDecimal, REFERENCES, const fmi3Float64 shifts[])
ABSENT(fmi3SetShiftFraction, REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
ABSENT(fmi3UpdateDiscreteStates, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals, fmi3Boolean *values,
       fmi3Boolean *has_next, fmi3Float64 *next)
ABSENT(fmi3GetOutputDerivatives, REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[], size_t value_count)
ABSENT_MODE(fmi3EnterEventMode)
ABSENT_MODE(fmi3EnterStepMode)
ABSENT_MODE(fmi3EnterConfigurationMode)
ABSENT_MODE(fmi3ExitConfigurationMode)
ABSENT_MODE(fmi3EvaluateDiscreteStates)

/* Units of the other kinds, which this one is not. */
ABSENT(fmi3CompletedIntegratorStep, fmi3Boolean no_return, fmi3Boolean *event, fmi3Boolean *terminate)
ABSENT(fmi3SetTime, fmi3Float64 time)
ABSENT(fmi3SetContinuousStates, const fmi3Float64 states[], size_t count)
ABSENT(fmi3GetContinuousStateDerivatives, fmi3Float64 derivatives[], size_t count)
ABSENT(fmi3GetEventIndicators, fmi3Float64 indicators[], size_t count)
ABSENT(fmi3GetContinuousStates, fmi3Float64 states[], size_t count)
ABSENT(fmi3GetNominalsOfContinuousStates, fmi3Float64 nominals[], size_t count)
ABSENT(fmi3GetNumberOfEventIndicators, size_t *count)
ABSENT(fmi3GetNumberOfContinuousStates, size_t *count)
ABSENT(fmi3ActivateModelPartition, fmi3ValueReference clock, fmi3Float64 time)
ABSENT_MODE(fmi3EnterContinuousTimeMode)

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                               fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback clock,
                                               fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock)
{
    return NULL;
}
