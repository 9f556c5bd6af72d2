/* The functions of FMI 2.0 that these units have no use for: importers look them up, and are told so. */
#include <fmi2Functions.h>

#include "instance.h"

#define ABSENT(name, ...)                                            \
    fmi2Status name(fmi2Component of, __VA_ARGS__)                   \
    {                                                                \
        instance_done(of, 0, #name " is not here: the unit has Real and Boolean variables without derivatives"); \
        return fmi2Error;                                            \
    }
#define REFERENCES const fmi2ValueReference references[], size_t count

ABSENT(fmi2GetInteger, REFERENCES, fmi2Integer values[])
ABSENT(fmi2SetInteger, REFERENCES, const fmi2Integer values[])
ABSENT(fmi2SetBoolean, REFERENCES, const fmi2Boolean values[])
ABSENT(fmi2GetString, REFERENCES, fmi2String values[])
ABSENT(fmi2SetString, REFERENCES, const fmi2String values[])
ABSENT(fmi2GetDirectionalDerivative, REFERENCES, const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seed[],
       fmi2Real sensitivity[])
ABSENT(fmi2SetRealInputDerivatives, REFERENCES, const fmi2Integer orders[], const fmi2Real values[])
ABSENT(fmi2GetRealOutputDerivatives, REFERENCES, const fmi2Integer orders[], fmi2Real values[])
ABSENT(fmi2GetStatus, const fmi2StatusKind kind, fmi2Status *value)
ABSENT(fmi2GetRealStatus, const fmi2StatusKind kind, fmi2Real *value)
ABSENT(fmi2GetIntegerStatus, const fmi2StatusKind kind, fmi2Integer *value)
ABSENT(fmi2GetBooleanStatus, const fmi2StatusKind kind, fmi2Boolean *value)
ABSENT(fmi2GetStringStatus, const fmi2StatusKind kind, fmi2String *value)

fmi2Status fmi2CancelStep(fmi2Component of)
{
    instance_done(of, 0, "fmi2CancelStep is not here: a step is done when it returns");
    return fmi2Error;
}
