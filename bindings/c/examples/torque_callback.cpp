// Torque callback at 1 kHz in the shape of libfranka's, with a stub in place of the robot: an impedance that is too stiff
// for torques that act late, made passive joint by joint.
//
// With libfranka: include <franka/robot.h>, remove the namespace `franka` below, and connect to your robot where the stub is
// placed; the callback stays as it is.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>

#include <lyapunov.hpp>

constexpr std::size_t joints = 7;
constexpr double period = 1e-3; // s
constexpr std::array<double, joints> inertia{{0.6, 0.6, 0.4, 0.4, 0.1, 0.1, 0.05}}; // the least that moves with each, kg.m2

// What of libfranka's names the callback uses.
namespace franka {

struct Duration {
    double seconds;
    double toSec() const { return seconds; }
};

struct RobotState {
    std::array<double, joints> q{};       // joint positions, rad
    std::array<double, joints> dq{};      // joint velocities, rad/s
    std::array<double, joints> tau_J_d{}; // torques commanded last, without gravity, N.m
};

struct Torques {
    explicit Torques(const std::array<double, joints> &torques) : tau_J(torques) {}
    std::array<double, joints> tau_J;
    bool motion_finished = false;
};

inline Torques MotionFinished(Torques torques)
{
    torques.motion_finished = true;
    return torques;
}

// Seven joints without coupling, under torques that act two ticks after the state that they answer.
class Robot {
public:
    void control(const std::function<Torques(const RobotState &, Duration)> &callback)
    {
        std::array<double, joints> coming{};
        for (int tick = 0;; ++tick) {
            const Torques told = callback(state, {tick == 0 ? 0.0 : period});
            if (told.motion_finished) {
                return;
            }
            for (int part = 0; part < 10; ++part) {
                for (std::size_t joint = 0; joint < joints; ++joint) {
                    state.dq[joint] += (coming[joint] - friction * state.dq[joint]) / inertia[joint] * (period / 10);
                    state.q[joint] += state.dq[joint] * (period / 10);
                }
            }
            state.tau_J_d = coming;
            coming = told.tau_J;
        }
    }

    static constexpr double friction = 0.05; // N.m.s/rad
    RobotState state;
};

} // namespace franka

namespace {

// A stabilizer for each joint: what one joint absorbed does not pay for another.
struct Joint {
    lyapunov::ReadingsMeasuredClocked<double> readings;
    lyapunov::Popc<double> popc;
};

bool prepared(std::array<Joint, joints> &stabilizers)
{
    for (std::size_t joint = 0; joint < joints; ++joint) {
        lyapunov::DampingLimit<double> limit;
        // Two ticks late, and 20 rad/s is more than a joint turns.
        const auto limited = limit.of_mass(0.5, inertia[joint], period, 2);
        const auto made = stabilizers[joint].popc.init({limit.most, 0.0});
        const auto read = stabilizers[joint].readings.init({period, 20.0});
        for (const auto &status : {limited, made, read}) {
            if (!status) {
                std::printf("joint %zu: %s\n", joint, status.text().data());
                return false;
            }
        }
    }
    return true;
}

// The largest angle from the start in the last second of eight, rad; the impedance pulls each joint there.
double late_swing(std::array<Joint, joints> stabilizers, bool stabilized)
{
    franka::Robot robot;
    std::array<double, joints> stiffness{};
    for (std::size_t joint = 0; joint < joints; ++joint) {
        stiffness[joint] = 4000.0 * inertia[joint]; // N.m/rad
        robot.state.q[joint] = 0.05;
    }
    double time = 0.0, swing = 0.0;
    robot.control([&](const franka::RobotState &state, franka::Duration since) -> franka::Torques {
        time += since.toSec();
        std::array<double, joints> torques{};
        for (std::size_t joint = 0; joint < joints; ++joint) {
            // Torques here act along the joint; efforts at a port act against its motion.
            const double wanted = stiffness[joint] * state.q[joint];
            auto &[readings, popc] = stabilizers[joint];
            // At the callback's own time: the robot skips a packet now and then, and the period is then two.
            const auto sample = readings.read_moving_at(time, state.q[joint], state.dq[joint], -state.tau_J_d[joint]).sample;
            const double effort = popc.step(sample, wanted).effort;
            torques[joint] = stabilized ? -effort : -wanted;
            swing = time >= 7.0 ? std::fmax(swing, std::fabs(state.q[joint])) : swing;
        }
        return time >= 8.0 ? franka::MotionFinished(franka::Torques(torques)) : franka::Torques(torques);
    });
    return swing;
}

} // namespace

int main()
{
    std::array<Joint, joints> stabilizers;
    if (!prepared(stabilizers)) {
        return 1;
    }
    const double alone = late_swing(stabilizers, false), stabilized = late_swing(stabilizers, true);
    std::printf("late swing alone      %10.4g rad\n", alone);
    std::printf("late swing with POPC  %10.4g rad\n", stabilized);
    return stabilized < 0.05 && alone > 10.0 * stabilized ? 0 : 1;
}
