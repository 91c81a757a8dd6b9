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

    /// All of the picture; where the source does not reach it is what lies `behind` (as large), and where that does not
    /// reach or there is none, `ground`.
    void paint(std::uint32_t ground, const WarpedPicture* behind, std::uint32_t* pixels) const;
    /// Is the plane seen about as large as in the source, about as tilted, and the middle of the picture in it?
    [[nodiscard]] bool isNear() const;
    /// Over how many pixels one of the source is drawn out, in the middle and where it is most; infinite: the source
    /// sees nothing of what is there.
    [[nodiscard]] double stretch() const;

private:
    WarpedPicture(const WarpSource& source, const glm::dmat3& sourceFromTarget, glm::ivec2 size)
        : m_source(source), m_sourceFromTarget(sourceFromTarget), m_size(size) {}
    /// Pixels of a row of the picture that follow one another, and where the middles of the first one and of the one
    /// after a full run lie in the source (homogeneous).
    struct Run {
        glm::ivec2 start;
        int count;
        glm::dvec3 from;
        glm::dvec3 to;
    };
    enum class Reach { None, Part, All };
    /// How one pixel to the right, and one down, of the middle of the picture move in the source.
    struct Middle {
        glm::dvec2 place;
        glm::dvec2 right;
        glm::dvec2 down;
    };

    void paintRun(glm::ivec2 start, std::uint32_t ground, const WarpedPicture* behind, std::uint32_t* out) const;
    [[nodiscard]] Run runAt(glm::ivec2 start) const;
    [[nodiscard]] Reach reachOf(const Run& run) const;
    void paintStraight(const Run& run, Reach reach, std::uint32_t* out) const;
    void paintBent(const Run& run, std::uint32_t* out) const;
    [[nodiscard]] glm::dvec3 sourceOf(glm::dvec2 pixel) const { return m_sourceFromTarget * glm::dvec3(pixel, 1.0); }
    [[nodiscard]] bool isInside(glm::i64vec2 pixel) const;
    [[nodiscard]] std::uint32_t pixelAt(glm::i64vec2 fixed) const;
    [[nodiscard]] std::optional<Middle> middle() const;

    WarpSource m_source;
    glm::dmat3 m_sourceFromTarget;  ///< pixels, homogeneous
    glm::ivec2 m_size;
};

}  // namespace render
