#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/tiles/flat_board.h"

namespace render {

/// A picture that is there already: where it lies, 0xffRRGGBB, rows from the top; no pixels: none.
struct RoughSource {
    const std::uint32_t* pixels = nullptr;
    glm::ivec2 size{0};
    PlaneMap map;
};

/// What lies at `map`, from `best` where it reaches, else from `rest`, else `ground`; between pixels of a source the
/// mean of its neighbours by distance (of sRGB bytes). Both must be turned like `map`, and stay as long as this does.
class RoughPicture {
public:
    RoughPicture(const RoughSource& best, const RoughSource& rest, std::uint32_t ground, const PlaneMap& map,
                 glm::ivec2 size);

    /// The pixels `from` to before `to` of a picture of that size, which starts at `pixels`. Any threads may paint
    /// parts that have no pixel in common.
    void paint(glm::ivec2 from, glm::ivec2 to, std::uint32_t* pixels) const;

private:
    /// Where a column or row of the picture lies in a source; pixel -1: beside it.
    struct Place {
        std::int32_t pixel = -1;
        std::uint32_t part = 0;  ///< of the next one, of 256
    };
    /// A source as the picture sees it, and the columns and rows that it reaches, as [first, end).
    struct Placed {
        RoughSource source;
        std::vector<Place> columns;
        std::vector<Place> rows;
        glm::ivec2 across{0};
        glm::ivec2 down{0};
    };
    class StretchedRows;

    static Placed placed(const RoughSource& source, const PlaneMap& map, glm::ivec2 size);
    static std::vector<Place> places(int count, double scale, double offset, int size);
    static glm::ivec2 reach(const std::vector<Place>& places);

    std::array<Placed, 2> m_sources;  ///< the better one last
    std::uint32_t m_ground;
    glm::ivec2 m_size;
};

}  // namespace render
