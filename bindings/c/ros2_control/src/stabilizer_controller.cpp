// Chainable controller of ros2_control that stands between an effort controller and the hardware, and keeps each joint passive.
//
// The controller before it writes the reference `NAME/JOINT/effort`; this one commands `JOINT/effort`. It reads position,
// velocity and effort of each joint, where effort is what the motor applied. Without a controller before it commands 0.
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <controller_interface/chainable_controller_interface.hpp>
#include <hardware_interface/types/hardware_interface_type_values.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <rclcpp/rclcpp.hpp>

#include "lyapunov_ros2_control/effort_stabilizer.hpp"

namespace lyapunov_ros2_control {

using controller_interface::CallbackReturn;
using controller_interface::InterfaceConfiguration;
using controller_interface::interface_configuration_type;
using controller_interface::return_type;

class StabilizerController : public controller_interface::ChainableControllerInterface {
public:
    CallbackReturn on_init() override
    {
        auto_declare<std::vector<std::string>>("joints", {});
        auto_declare<std::vector<double>>("inertia", {});
        auto_declare<std::vector<double>>("fastest", {});
        auto_declare<int>("late", 1);
        return CallbackReturn::SUCCESS;
    }

    InterfaceConfiguration command_interface_configuration() const override
    {
        return {interface_configuration_type::INDIVIDUAL, interfaces({hardware_interface::HW_IF_EFFORT})};
    }

    InterfaceConfiguration state_interface_configuration() const override
    {
        return {interface_configuration_type::INDIVIDUAL,
                interfaces({hardware_interface::HW_IF_POSITION, hardware_interface::HW_IF_VELOCITY, hardware_interface::HW_IF_EFFORT})};
    }

    CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
    {
        names_ = get_node()->get_parameter("joints").as_string_array();
        const auto inertia = get_node()->get_parameter("inertia").as_double_array();
        const auto fastest = get_node()->get_parameter("fastest").as_double_array();
        const auto late = get_node()->get_parameter("late").as_int();
        if (names_.empty() || inertia.size() != names_.size() || fastest.size() != names_.size()) {
            return refuse("joints, inertia and fastest must have one entry for each joint, and at least one joint");
        }
        if (late < 0 || late > std::numeric_limits<std::int32_t>::max() || get_update_rate() == 0) {
            return refuse("late must be a number of updates, 0 or more, and update_rate above 0");
        }
        std::vector<JointLimits> joints;
        for (std::size_t at = 0; at < names_.size(); ++at) {
            joints.push_back({names_[at], inertia[at], fastest[at]});
        }
        const auto refused = stabilizer_.configure(1.0 / get_update_rate(), static_cast<std::uint32_t>(late), joints);
        reference_interfaces_.assign(names_.size(), std::numeric_limits<double>::quiet_NaN());
        return refused.empty() ? CallbackReturn::SUCCESS : refuse(refused);
    }

    CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
    {
        stabilizer_.restart();
        now_ = 0.0;
        reference_interfaces_.assign(names_.size(), std::numeric_limits<double>::quiet_NaN());
        return CallbackReturn::SUCCESS;
    }

    CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override
    {
        return command_all([](std::size_t) { return 0.0; }) ? CallbackReturn::SUCCESS : CallbackReturn::ERROR;
    }

protected:
    std::vector<hardware_interface::CommandInterface> on_export_reference_interfaces() override
    {
        std::vector<hardware_interface::CommandInterface> references;
        for (std::size_t at = 0; at < names_.size(); ++at) {
            references.emplace_back(get_node()->get_name(), names_[at] + "/" + hardware_interface::HW_IF_EFFORT,
                                    &reference_interfaces_[at]);
        }
        return references;
    }

    return_type update_reference_from_subscribers(const rclcpp::Time &, const rclcpp::Duration &) override
    {
        return return_type::OK; // there are none
    }

    return_type update_and_write_commands(const rclcpp::Time &, const rclcpp::Duration &period) override
    {
        // Summed periods: the seconds of a clock since 1970 have too few digits left for a period.
        now_ += period.seconds();
        const auto told = [this](std::size_t at) {
            return state_interfaces_[at].get_optional().value_or(std::numeric_limits<double>::quiet_NaN());
        };
        const bool written = command_all([&](std::size_t at) {
            const JointReading reading{told(3 * at), told(3 * at + 1), told(3 * at + 2)};
            return stabilizer_.command(at, now_, reading, reference_interfaces_[at]);
        });
        return written ? return_type::OK : return_type::ERROR;
    }

private:
    CallbackReturn refuse(const std::string &why)
    {
        RCLCPP_ERROR(get_node()->get_logger(), "%s", why.c_str());
        return CallbackReturn::ERROR;
    }

    std::vector<std::string> interfaces(const std::vector<std::string> &kinds) const
    {
        std::vector<std::string> all;
        for (const auto &name : names_) {
            for (const auto &kind : kinds) {
                all.push_back(name + "/" + kind);
            }
        }
        return all;
    }

    template <class Effort> bool command_all(Effort effort)
    {
        bool written = true;
        for (std::size_t at = 0; at < command_interfaces_.size(); ++at) {
            written = command_interfaces_[at].set_value(effort(at)) && written;
        }
        return written;
    }

    std::vector<std::string> names_;
    EffortStabilizer stabilizer_;
    double now_ = 0.0;
};

} // namespace lyapunov_ros2_control

PLUGINLIB_EXPORT_CLASS(lyapunov_ros2_control::StabilizerController, controller_interface::ChainableControllerInterface)
