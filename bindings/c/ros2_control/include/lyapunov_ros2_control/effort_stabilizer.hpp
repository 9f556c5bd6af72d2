// Stabilizers of a robot's joints, without ROS: what the controller does on each update.
#ifndef LYAPUNOV_ROS2_CONTROL_EFFORT_STABILIZER_HPP
#define LYAPUNOV_ROS2_CONTROL_EFFORT_STABILIZER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <lyapunov.hpp>

namespace lyapunov_ros2_control {

// What is known of a joint: N.m and rad, or N and m if it slides.
struct JointLimits {
    std::string name;
    double inertia; // the least that moves with the joint, kg.m2
    double fastest; // rad/s; a reading that is farther away is rejected
};

// What a joint tells on an update. Efforts are along the joint, as ros2_control has them.
struct JointReading {
    double position;
    double velocity;
    double applied; // effort that acted since the last update
};

// A passivity observer/controller for each joint: what one joint absorbed does not pay for another.
class EffortStabilizer {
public:
    // Empty, or what is wrong and what would be right. Allocates; nothing else here does.
    std::string configure(double period, std::uint32_t late, const std::vector<JointLimits> &joints)
    {
        std::vector<Joint> made(joints.size());
        for (std::size_t at = 0; at < joints.size(); ++at) {
            lyapunov::DampingLimit<double> limit;
            const auto limited = limit.of_mass(0.5, joints[at].inertia, period, late);
            const auto damped = made[at].popc.init({limit.most, 0.0});
            const auto read = made[at].readings.init({period, joints[at].fastest});
            for (const auto *status : {&limited, &damped, &read}) {
                if (!*status) {
                    return "joint " + joints[at].name + ": " + status->text().data();
                }
            }
        }
        fresh_ = made;
        joints_ = std::move(made);
        return {};
    }

    // Forgets positions, credit and debt: for an activation, before which the joints moved unread.
    void restart() noexcept
    {
        for (std::size_t at = 0; at < joints_.size(); ++at) {
            joints_[at] = fresh_[at];
        }
    }

    std::size_t size() const noexcept { return joints_.size(); }

    // The effort to command, along the joint, for the effort that was asked for; `now` is in s from the activation. 0 if the
    // reading or what was asked for cannot be used, or there is no such joint.
    double command(std::size_t joint, double now, const JointReading &reading, double asked) noexcept
    {
        if (joint >= joints_.size()) {
            return 0.0;
        }
        auto &[readings, popc] = joints_[joint];
        // Efforts at a port act against its motion.
        const auto read = readings.read_moving_at(now, reading.position, reading.velocity, -reading.applied);
        return -popc.step(read.sample, -asked).effort;
    }

    // J; below 0 it is a debt.
    double observed_energy(std::size_t joint) const noexcept { return joints_[joint].popc.observed_energy(); }

private:
    struct Joint {
        lyapunov::ReadingsMeasuredClocked<double> readings;
        lyapunov::Popc<double> popc;
    };
    std::vector<Joint> fresh_;
    std::vector<Joint> joints_;
};

} // namespace lyapunov_ros2_control

#endif
