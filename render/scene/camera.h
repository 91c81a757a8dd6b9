#pragma once

#include <array>
#include <glm/glm.hpp>

namespace render {

enum class NamedView { Top, Bottom, Iso };

/// Where a camera is and looks.
struct CameraPose {
    glm::vec3 target{0.0F};
    float distance = 100.0F;  ///< mm from the eye to the target; also sets the size of an orthographic view
    float yaw = 0.0F;         ///< rad, 0 looks along +y
    float pitch = 0.0F;       ///< rad, -π/2 looks straight down
    bool isOrthographic = false;
    bool operator==(const CameraPose&) const = default;
};

/// Orbit camera in board model coordinates (mm, z up). Pure arithmetic; input handling lives in ui/.
class Camera {
public:
    /// Looks at the box from a named direction so that all of it is seen.
    void fit(const glm::vec3& boxMin, const glm::vec3& boxMax, NamedView view, float aspect);
    /// Keeps the direction and fits the box.
    void fit(const glm::vec3& boxMin, const glm::vec3& boxMax, float aspect);
    /// What is fitted or shown leaves a margin: the picture is this many times as large.
    static constexpr float kMargin = 1.06F;
    /// Fills the picture with a part of the scene, direction unchanged.
    void show(const glm::vec3& boxMin, const glm::vec3& boxMax, float aspect);
    /// Looks straight on a rectangle given in mm, from the top or the bottom, orthographic and without margin (`render
    /// --window`).
    void fitWindow(const glm::vec2& min, const glm::vec2& max, float z, float aspect, NamedView view = NamedView::Top);

    void orbit(float yawRad, float pitchRad);
    /// Looks from the other side at the same target: left and right change sides, up stays up.
    void flipOver();
    /// Moves with the pointer: `pixels` on a viewport `height` pixels high; the point under the pointer stays under it.
    void pan(const glm::vec2& pixels, float height);
    /// Zooms by `factor` (> 1 is closer) keeping the point under the pointer; `ndc` in -1..1, y up.
    void zoom(float factor, const glm::vec2& ndc, float aspect);
    /// Moves the target along the line of sight to the depth of `point`, which changes nothing in the picture:
    /// orbiting, panning and zooming then go by what is there, and a zoom can come as near to it as it likes. A point
    /// behind the eye is ignored.
    void focusOn(const glm::vec3& point);
    /// The same for the location where the line of sight meets height `z`; does nothing when it does not.
    void focusOnHeight(float z);
    void setOrthographic(bool isOrthographic) { m_pose.isOrthographic = isOrthographic; }
    [[nodiscard]] bool isOrthographic() const { return m_pose.isOrthographic; }

    [[nodiscard]] const CameraPose& pose() const { return m_pose; }
    /// Takes a pose over, within what the camera can do.
    void setPose(const CameraPose& pose);

    [[nodiscard]] glm::mat4 view() const;
    /// Reversed z (near = 1, far = 0), y down as Vulkan wants it.
    [[nodiscard]] glm::mat4 projection(float aspect) const;
    [[nodiscard]] glm::vec3 eye() const;
    [[nodiscard]] glm::vec3 direction() const;  ///< from the eye into the scene, unit length
    /// Millimetres per pixel at the target.
    [[nodiscard]] float mmPerPixel(float height) const;
    [[nodiscard]] glm::vec3 target() const { return m_pose.target; }

private:
    [[nodiscard]] float distanceToSee(const std::array<glm::vec3, 8>& corners, float aspect) const;
    void centre(const std::array<glm::vec3, 8>& corners);

    CameraPose m_pose;
    float m_radius = 100.0F;  ///< mm, of the scene: near and far planes enclose it
};

}  // namespace render
