#include "render/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "render/modelling/board_frame.h"

namespace render {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kFieldOfView = 40.0F * kPi / 180.0F;  // vertical; long enough a lens that a board appears flat
constexpr float kStraightDown = -kPi / 2.0F;
constexpr float kMinDistance = 0.01F;  // mm: 7 µm high views, below that floats of the model end

/// Half the height of what is seen at distance 1.
float halfHeightAtOne() {
    return std::tan(kFieldOfView / 2.0F);
}

std::array<glm::vec3, 8> cornersOf(const glm::vec3& boxMin, const glm::vec3& boxMax) {
    std::array<glm::vec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        corners[i] = {(i & 1U) != 0 ? boxMax.x : boxMin.x, (i & 2U) != 0 ? boxMax.y : boxMin.y,
                      (i & 4U) != 0 ? boxMax.z : boxMin.z};
    }
    return corners;
}

/// Of the named views. The bottom is seen as if the board were flipped about its vertical axis: left and right change
/// sides, up stays up.
constexpr std::pair<float, float> kYawAndPitch[] = {
    {0.0F, kStraightDown}, {kPi, -kStraightDown}, {kPi / 6.0F, -kPi / 4.5F}};

}  // namespace

void Camera::fit(const glm::vec3& boxMin, const glm::vec3& boxMax, NamedView view, float aspect) {
    std::tie(m_pose.yaw, m_pose.pitch) = kYawAndPitch[static_cast<std::size_t>(view)];
    fit(boxMin, boxMax, aspect);
}

void Camera::fit(const glm::vec3& boxMin, const glm::vec3& boxMax, float aspect) {
    m_radius = std::max(glm::length(boxMax - boxMin) / 2.0F, kMinDistance);
    show(boxMin, boxMax, aspect);
}

void Camera::show(const glm::vec3& boxMin, const glm::vec3& boxMax, float aspect) {
    m_pose.target = (boxMin + boxMax) / 2.0F;
    const std::array<glm::vec3, 8> corners = cornersOf(boxMin, boxMax);
    // In perspective the near side takes more room than the far side: a few steps bring the picture's middle to the
    // middle.
    for (int step = 0; step < (m_pose.isOrthographic ? 1 : 4); ++step) {
        m_pose.distance = distanceToSee(corners, aspect);
        if (!m_pose.isOrthographic) {
            centre(corners);
        }
    }
    m_pose.distance = distanceToSee(corners, aspect);
}

/// How far the eye must move back until every corner is inside both angles of the frustum.
float Camera::distanceToSee(const std::array<glm::vec3, 8>& corners, float aspect) const {
    const glm::mat3 rotation(view());
    float distance = kMinDistance;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 seen = rotation * (corner - m_pose.target);  // x right, y up, z towards the eye
        const float needed = std::max(std::abs(seen.y), std::abs(seen.x) / aspect) * kMargin / halfHeightAtOne();
        distance = std::max(distance, m_pose.isOrthographic ? needed : needed + seen.z);
    }
    return distance;
}

/// Shifts the target so that the corners' picture extends as far to the left as to the right, and as far up as down.
void Camera::centre(const std::array<glm::vec3, 8>& corners) {
    const glm::mat3 rotation(view());
    Box2 picture;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 seen = rotation * (corner - m_pose.target);
        picture.include(glm::vec2(seen) / (m_pose.distance - seen.z));
    }
    const glm::vec2 middle = (picture.min + picture.max) / 2.0F;
    m_pose.target += glm::transpose(rotation) * glm::vec3(middle * m_pose.distance, 0.0F);
}

void Camera::fitWindow(const glm::vec2& min, const glm::vec2& max, float z, float aspect, NamedView view) {
    std::tie(m_pose.yaw, m_pose.pitch) = kYawAndPitch[static_cast<std::size_t>(view)];
    m_pose.isOrthographic = true;
    m_pose.target = {(min + max) / 2.0F, z};
    const glm::vec2 half = glm::abs(max - min) / 2.0F;
    m_pose.distance = std::max(std::max(half.y, half.x / aspect) / halfHeightAtOne(), kMinDistance);
    m_radius = std::max(m_radius, glm::length(half));
}

void Camera::orbit(float yawRad, float pitchRad) {
    m_pose.yaw += yawRad;
    m_pose.pitch = std::clamp(m_pose.pitch + pitchRad, kStraightDown, -kStraightDown);
}

void Camera::flipOver() {
    m_pose.yaw += m_pose.yaw > 0.0F ? -kPi : kPi;  // twice is back, exactly
    m_pose.pitch = -m_pose.pitch;
}

void Camera::pan(const glm::vec2& pixels, float height) {
    const glm::mat3 toWorld = glm::transpose(glm::mat3(view()));
    m_pose.target -= toWorld * glm::vec3(pixels.x, -pixels.y, 0.0F) * mmPerPixel(height);
}

void Camera::zoom(float factor, const glm::vec2& ndc, float aspect) {
    const float newDistance = std::clamp(m_pose.distance / factor, kMinDistance, 50.0F * m_radius);
    const float halfHeight = m_pose.distance * halfHeightAtOne();
    const glm::vec3 atPointer{ndc.x * halfHeight * aspect, ndc.y * halfHeight, 0.0F};
    const glm::mat3 toWorld = glm::transpose(glm::mat3(view()));
    m_pose.target += toWorld * atPointer * (1.0F - newDistance / m_pose.distance);
    m_pose.distance = newDistance;
}

void Camera::focusOn(const glm::vec3& point) {
    const float depth = glm::dot(point - eye(), direction());
    if (depth <= kMinDistance && !m_pose.isOrthographic) {
        return;
    }
    m_pose.target += direction() * (depth - m_pose.distance);
    if (!m_pose.isOrthographic) {
        m_pose.distance =
            depth;  // the eye stays; an orthographic view keeps its scale instead, and the eye may move along
    }
}

void Camera::focusOnHeight(float z) {
    const float depth = (z - eye().z) / direction().z;
    if (std::isfinite(depth) && depth > 0.0F) {
        focusOn(eye() + direction() * depth);
    }
}

glm::vec3 Camera::direction() const {
    return {std::sin(m_pose.yaw) * std::cos(m_pose.pitch), std::cos(m_pose.yaw) * std::cos(m_pose.pitch),
            std::sin(m_pose.pitch)};
}

glm::vec3 Camera::eye() const {
    return m_pose.target - direction() * m_pose.distance;
}

void Camera::setPose(const CameraPose& pose) {
    m_pose = pose;
    m_pose.distance = std::max(pose.distance, kMinDistance);
    m_pose.pitch = std::clamp(pose.pitch, kStraightDown, -kStraightDown);
}

glm::mat4 Camera::view() const {
    // Up by the angles and not by a fixed axis: straight down has no singularity.
    const glm::vec3 up{-std::sin(m_pose.yaw) * std::sin(m_pose.pitch), -std::cos(m_pose.yaw) * std::sin(m_pose.pitch),
                       std::cos(m_pose.pitch)};
    return glm::lookAt(eye(), m_pose.target, up);
}

glm::mat4 Camera::projection(float aspect) const {
    // The scene's sphere, wherever the target was panned to, with room for an exploded stackup.
    const float far = m_pose.distance + 4.0F * m_radius;
    const float halfHeight = m_pose.distance * halfHeightAtOne();
    glm::mat4 p(0.0F);
    if (m_pose.isOrthographic) {
        // Depth 1 at -far behind the eye to 0 at far: nothing is cut off by zooming in.
        p[0][0] = 1.0F / (halfHeight * aspect);
        p[1][1] = -1.0F / halfHeight;
        p[2][2] = 0.5F / far;
        p[3][2] = 0.5F;
        p[3][3] = 1.0F;
        return p;
    }
    // Reversed z with the far plane at infinity: depth = near / distance.
    const float near = std::max(m_pose.distance * 0.01F, 1e-3F);
    p[0][0] = 1.0F / (halfHeightAtOne() * aspect);
    p[1][1] = -1.0F / halfHeightAtOne();
    p[2][3] = -1.0F;
    p[3][2] = near;
    return p;
}

float Camera::mmPerPixel(float height) const {
    return 2.0F * m_pose.distance * halfHeightAtOne() / height;
}

}  // namespace render
