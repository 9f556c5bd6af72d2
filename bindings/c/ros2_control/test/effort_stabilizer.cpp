// The controller's logic without ROS: two joints under an effort controller that is too stiff for its loop.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lyapunov_ros2_control/effort_stabilizer.hpp"

using lyapunov_ros2_control::EffortStabilizer;
using lyapunov_ros2_control::JointLimits;

namespace {

constexpr double period = 1e-3;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

int failures = 0;

void expect(bool holds, const char *what)
{
    if (!holds) {
        std::printf("failed: %s\n", what);
        ++failures;
    }
}

std::vector<JointLimits> two_joints()
{
    return {{"shoulder", 0.5, 20.0}, {"elbow", 0.1, 20.0}};
}

struct Plant {
    double inertia;
    double position = 0.05;
    double velocity = 0.0;
    double applied = 0.0; // acts until the next update
    double coming = 0.0;  // acts from then on: hardware that is an update late

    double energy_taken(double command)
    {
        const double before = position;
        applied = coming;
        for (int part = 0; part < 10; ++part) {
            velocity += (applied - 0.05 * velocity) / inertia * (period / 10);
            position += velocity * (period / 10);
        }
        coming = command;
        return -applied * (position - before);
    }
};

struct Outcome {
    double swing = 0.0;       // the largest in the last second of four, rad
    double mismatch = 0.0;    // between the sum of the stabilizer and the work that the joints really took, J
};

// Updates come with a jitter of a tenth of the period, as the clock tells it.
Outcome run(bool stabilized)
{
    EffortStabilizer stabilizer;
    expect(stabilizer.configure(period, 1, two_joints()).empty(), "two plain joints are taken");
    Plant joints[] = {{0.5}, {0.1}};
    double taken[] = {0.0, 0.0};
    Outcome outcome;
    for (int tick = 0; tick < 4000; ++tick) {
        const double now = tick * period + (tick % 2) * 0.1 * period;
        for (std::size_t at = 0; at < 2; ++at) {
            auto &joint = joints[at];
            const double asked = -4000.0 * joint.inertia * joint.position;
            const double command = stabilizer.command(at, now, {joint.position, joint.velocity, joint.applied}, asked);
            outcome.mismatch = std::max(outcome.mismatch, stabilized ? std::fabs(stabilizer.observed_energy(at) - taken[at]) : 0.0);
            taken[at] += joint.energy_taken(stabilized ? command : asked);
            if (tick >= 3000) {
                outcome.swing = std::max(outcome.swing, std::fabs(joint.position));
            }
        }
    }
    return outcome;
}

void refuses_what_cannot_be()
{
    EffortStabilizer stabilizer;
    auto joints = two_joints();
    joints[1].inertia = -1.0;
    const auto refused = stabilizer.configure(period, 1, joints);
    expect(refused.find("elbow") != std::string::npos && refused.find("-1") != std::string::npos, "joint and value are named");
    expect(stabilizer.size() == 0 && stabilizer.command(0, 0.0, {}, 1.0) == 0.0, "nothing is commanded before it is configured");
    expect(!stabilizer.configure(0.0, 1, two_joints()).empty(), "a period of 0 is refused");
}

void rejects_what_cannot_be_used()
{
    EffortStabilizer stabilizer;
    expect(stabilizer.configure(period, 1, two_joints()).empty(), "two plain joints are taken");
    expect(stabilizer.command(0, period, {0.0, 0.0, 0.0}, 2.0) == 2.0, "an effort without a debt passes as it is");
    expect(stabilizer.command(0, 2 * period, {nan, 0.0, 0.0}, 2.0) == 0.0, "an unreadable position commands 0");
    expect(stabilizer.command(0, 3 * period, {0.0, 0.0, 0.0}, nan) == 0.0, "without a reference the command is 0");
    expect(stabilizer.command(0, 4 * period, {0.0, 0.0, 0.0}, 2.0) == 2.0, "the next good one passes");
    stabilizer.restart();
    expect(stabilizer.command(0, period, {3.0, 0.0, 5.0}, 2.0) == 2.0 && stabilizer.observed_energy(0) == 0.0,
           "what moved before an activation is not booked");
}

} // namespace

int main()
{
    const auto alone = run(false), stabilized = run(true);
    std::printf("late swing alone %.3g rad, stabilized %.3g rad; energy off by at most %.2g J\n", alone.swing, stabilized.swing,
                stabilized.mismatch);
    expect(stabilized.swing < 0.05 && alone.swing > 10.0 * stabilized.swing, "the stabilizer holds what grows alone");
    expect(stabilized.mismatch < 1e-9, "the sum of each joint is the work that the joint took");
    refuses_what_cannot_be();
    rejects_what_cannot_be_used();
    return failures == 0 ? 0 : 1;
}
