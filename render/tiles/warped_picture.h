#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace render {

/// How a camera sees a level plane of the board: clip space (x, y, w; y down) from x, y in millimetres and 1.
[[nodiscard]] glm::dmat3 clipFromPlane(const glm::mat4& clipFromBoard, float z);

/// A picture of a board, and how its camera saw the plane that most of it lies in.
struct WarpSource {
    const std::uint32_t* pixels = nullptr;  ///< 0xffRRGGBB, rows from the top
    glm::ivec2 size{0};
    glm::dmat3 clipFromPlane{1.0};
};

/// What another camera would see if all of a picture lay in one plane: what to show while the device draws. Boards are
/// flat, so that this strays little until the view has turned far.
class WarpedPicture {
public:
    /// None: they look at different faces of the plane, or one of them along it.
    [[nodiscard]] static std::optional<WarpedPicture> make(const WarpSource& source, const glm::dmat3& clipFromPlane,
                                                           glm::ivec2 size);

    /// All of the picture; where the source does not reach it is `ground`.
    void paint(std::uint32_t ground, std::uint32_t* pixels) const;
    /// Is the plane seen about as large as in the source, about as tilted, and the middle of the picture in it?
    [[nodiscard]] bool isNear() const;

private:
    WarpedPicture(const WarpSource& source, const glm::dmat3& sourceFromTarget, glm::ivec2 size)
        : m_source(source), m_sourceFromTarget(sourceFromTarget), m_size(size) {}
    void paintRow(int y, std::uint32_t ground, std::uint32_t* out) const;
    /// Pixels between `from` and `to` of the source, which lie so far apart in the picture.
    void paintRun(glm::dvec2 from, glm::dvec2 to, int count, std::uint32_t ground, std::uint32_t* out) const;
    [[nodiscard]] glm::dvec2 at(const glm::dvec3& homogeneous) const;

    WarpSource m_source;
    glm::dmat3 m_sourceFromTarget;  ///< pixels, homogeneous
    glm::ivec2 m_size;
};

}  // namespace render
