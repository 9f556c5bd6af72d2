/* Prints modelDescription.xml of a unit, for the version of FMI in -DFMI. */
#include <stdio.h>

#include "variables.h"

struct variable {
    const char *name;
    enum kind kind;
    double start;
    const char *unit;
    const char *description;
};

#define ROW(name, kind, start, unit, description) { #name, kind, start, unit, description },
static const struct variable variables[] = { VARIABLES(ROW) };

static const char *const units =
    "  <UnitDefinitions>\n"
    "    <Unit name=\"s\"><BaseUnit s=\"1\"/></Unit>\n"
    "    <Unit name=\"m\"><BaseUnit m=\"1\"/></Unit>\n"
    "    <Unit name=\"m/s\"><BaseUnit m=\"1\" s=\"-1\"/></Unit>\n"
    "    <Unit name=\"N\"><BaseUnit kg=\"1\" m=\"1\" s=\"-2\"/></Unit>\n"
    "    <Unit name=\"N.s/m\"><BaseUnit kg=\"1\" s=\"-1\"/></Unit>\n"
    "    <Unit name=\"J\"><BaseUnit kg=\"1\" m=\"2\" s=\"-2\"/></Unit>\n"
    "  </UnitDefinitions>\n";

static const char *attributes(enum kind kind)
{
    switch (kind) {
    case INDEPENDENT: return "causality=\"independent\" variability=\"continuous\"";
    case PARAMETER: return "causality=\"parameter\" variability=\"fixed\"";
    case INPUT: return "causality=\"input\" variability=\"discrete\"";
    default: return "causality=\"output\" variability=\"discrete\" initial=\"calculated\"";
    }
}

static void typed(const struct variable *variable)
{
    if (variable->unit[0] != '\0') {
        printf(" unit=\"%s\"", variable->unit);
    }
    if (variable->kind == PARAMETER || variable->kind == INPUT) {
        printf(" start=\"%.17g\"", variable->start);
    }
}

static void variable(int at)
{
    const struct variable *of = &variables[at];

#if FMI == 3
    printf("    <%s name=\"%s\" valueReference=\"%d\" %s description=\"%s\"", of->kind == FLAG ? "Boolean" : "Float64",
           of->name, at, attributes(of->kind), of->description);
    typed(of);
    printf("/>\n");
#else
    printf("    <ScalarVariable name=\"%s\" valueReference=\"%d\" %s description=\"%s\"><%s", of->name, at, attributes(of->kind),
           of->description, of->kind == FLAG ? "Boolean" : "Real");
    typed(of);
    printf("/></ScalarVariable>\n");
#endif
}

/* Variables are numbered from 0 in FMI 3.0, by their references, and from 1 in FMI 2.0, by their places. */
enum { FIRST = FMI == 3 ? 0 : 1 };
static const char *const number = FMI == 3 ? "valueReference" : "index";

static void outputs(const char *element, int initial)
{
    int at;

    for (at = 0; at < VARIABLE_COUNT; ++at) {
        if (variables[at].kind == OUTPUT || variables[at].kind == FLAG) {
            printf("    %s<%s %s=\"%d\" dependencies=\"", FMI == 3 ? "" : "  ", element, number, at + FIRST);
            if (initial && at == VARIABLE_observed_energy) {
                printf("%d", VARIABLE_budget + FIRST);
            }
            printf("\"/>\n");
        }
    }
}

int main(void)
{
    int at;

    printf("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
#if FMI == 3
    printf("<fmiModelDescription fmiVersion=\"3.0\" modelName=\"%s\" instantiationToken=\"%s\"\n", IDENTIFIER, TOKEN);
#else
    printf("<fmiModelDescription fmiVersion=\"2.0\" modelName=\"%s\" guid=\"%s\"\n", IDENTIFIER, TOKEN);
#endif
    printf("    description=\"%s\" version=\"%s\" license=\"MIT OR Apache-2.0\"\n", DESCRIPTION, VERSION);
    printf("    variableNamingConvention=\"flat\">\n");
#if FMI == 3
    printf("  <CoSimulation modelIdentifier=\"%s\" canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"/>\n", IDENTIFIER);
    printf("%s  <ModelVariables>\n", units);
#else
    printf("  <CoSimulation modelIdentifier=\"%s\" canHandleVariableCommunicationStepSize=\"false\"\n"
           "      canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"/>\n", IDENTIFIER);
    printf("%s  <ModelVariables>\n", units);
#endif
    for (at = 0; at < VARIABLE_COUNT; ++at) {
        variable(at);
    }
    printf("  </ModelVariables>\n  <ModelStructure>\n");
#if FMI == 3
    outputs("Output", 0);
    outputs("InitialUnknown", 1);
#else
    printf("    <Outputs>\n");
    outputs("Unknown", 0);
    printf("    </Outputs>\n    <InitialUnknowns>\n");
    outputs("Unknown", 1);
    printf("    </InitialUnknowns>\n");
#endif
    printf("  </ModelStructure>\n</fmiModelDescription>\n");
    return 0;
}
