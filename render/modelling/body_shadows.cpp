#include "render/modelling/body_shadows.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "model/base/parallel.h"
#include "render/modelling/area_loops.h"
#include "render/modelling/board_model.h"
#include "render/modelling/edge_grid.h"

namespace render {
namespace {

constexpr float kReachOfHeight = 0.9F;
/// What begins higher than this above the board, mm, does not touch it.
constexpr float kContact = 0.1F;
constexpr float kDark = 255.0F;
/// Rows of corners that are a task.
constexpr std::uint32_t kBand = 32;

/// Something that stands on the board.
struct Caster {
    std::vector<Edge> outline;
    Box2 box;  ///< around it
    float reach = 0.0F;
};

Caster casterOf(const BoardModel& model, const shader::AreaInstance& instance) {
    Caster caster;
    forLoops(model, instance, [&](const Loop& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            caster.outline.push_back({loop[i], loop[(i + 1) % loop.size()]});
            caster.box.include(loop[i]);
        }
    });
    caster.reach = std::clamp(kReachOfHeight * instance.height, kShortestShadow, kLongestShadow);
    return caster;
}

/// `growth`: away from which side of the board they grow.
std::vector<Caster> castersOf(const BoardModel& model, std::uint32_t growth) {
    std::vector<Caster> casters;
    for (const shader::AreaInstance& instance : model.instances) {
        if (model.layers[instance.layer].growth == growth && instance.height > 0.0F && instance.floor <= kContact) {
            casters.push_back(casterOf(model, instance));
        }
    }
    std::erase_if(casters, [](const Caster& caster) { return caster.outline.empty(); });
    return casters;
}

/// What a map covers: the board where it can be dark.
Box2 coverOf(const BoardModel& model, const std::vector<Caster>& casters) {
    Box2 box;
    for (const Caster& caster : casters) {
        box.include(caster.box);
    }
    return {glm::max(box.min - kLongestShadow, glm::vec2(model.boxMin)),
            glm::min(box.max + kLongestShadow, glm::vec2(model.boxMax))};
}

/// The corners of a map while it is made.
class Corners {
public:
    Corners(const Box2& cover, std::vector<Caster> casters) : m_casters(std::move(casters)) {
        const glm::vec2 size = cover.max - cover.min;
        m_cell = std::max(kFinestShadowCell, std::max(size.x, size.y) / float(kMostShadowCells - 2));
        m_origin = cover.min - m_cell;
        m_width = static_cast<std::uint32_t>(std::ceil(size.x / m_cell)) + 3;
        m_height = static_cast<std::uint32_t>(std::ceil(size.y / m_cell)) + 3;
        m_values.resize(std::size_t{m_width} * m_height);
        for (Caster& caster : m_casters) {
            caster.reach = std::max(caster.reach, 2.0F * m_cell);
        }
    }

    void darken() {
        base::parallelFor((m_height + kBand - 1) / kBand, [&](std::size_t band) {
            const auto first = static_cast<std::uint32_t>(band) * kBand;
            const Run rows{std::max(first, 1U), std::min(first + kBand, m_height - 1)};
            Nearest nearest;
            for (const Caster& caster : m_casters) {
                darkenRows(caster, rows, nearest);
            }
        });
    }

    [[nodiscard]] ShadowMap map() const {
        ShadowMap map{{m_origin, m_cell, m_width - 1, m_height - 1}, {}};
        map.cells.reserve(std::size_t{map.width} * map.height);
        for (std::uint32_t y = 0; y < map.height; ++y) {
            const std::uint8_t* lower = &m_values[std::size_t{y} * m_width];
            const std::uint8_t* upper = lower + m_width;
            for (std::uint32_t x = 0; x < map.width; ++x) {
                map.cells.push_back(lower[x] | lower[x + 1] << 8U | upper[x] << 16U |
                                    static_cast<std::uint32_t>(upper[x + 1]) << 24U);
            }
        }
        return map;
    }

private:
    /// Corners from `first` to before `end`, which is no less.
    struct Run {
        std::uint32_t first = 0;
        std::uint32_t end = 0;
    };

    /// All of a row but those on the rim.
    [[nodiscard]] Run insideRim() const { return {1, m_width - 1}; }
    /// Those from `low` to `high` mm along an axis, within a run.
    [[nodiscard]] Run cornersWithin(float low, float high, float origin, const Run& run) const {
        const float first = std::ceil((low - origin) / m_cell);
        const float last = std::floor((high - origin) / m_cell);
        const std::uint32_t begin = std::clamp(static_cast<std::uint32_t>(std::max(first, 0.0F)), run.first, run.end);
        return {begin, std::clamp(static_cast<std::uint32_t>(std::max(last + 1.0F, 0.0F)), begin, run.end)};
    }
    [[nodiscard]] float xOf(std::uint32_t column) const { return m_origin.x + m_cell * static_cast<float>(column); }
    [[nodiscard]] float yOf(std::uint32_t row) const { return m_origin.y + m_cell * static_cast<float>(row); }
    [[nodiscard]] std::uint8_t* rowAt(std::uint32_t row) { return &m_values[std::size_t{row} * m_width]; }

    /// How far corners are from the outline of a caster.
    struct Nearest {
        Run rows;
        Run columns;
        std::vector<float> squares;  ///< of distances in mm, row by row

        [[nodiscard]] std::span<float> rowAt(std::uint32_t row) {
            const std::size_t width = columns.end - columns.first;
            return std::span(squares).subspan((row - rows.first) * width, width);
        }
    };

    /// Of the corners in its reach.
    void measure(const Caster& caster, const Run& within, Nearest& nearest) const {
        const Box2 box{caster.box.min - caster.reach, caster.box.max + caster.reach};
        nearest.rows = cornersWithin(box.min.y, box.max.y, m_origin.y, within);
        nearest.columns = cornersWithin(box.min.x, box.max.x, m_origin.x, insideRim());
        const std::size_t count =
            std::size_t{nearest.rows.end - nearest.rows.first} * (nearest.columns.end - nearest.columns.first);
        nearest.squares.assign(count, caster.reach * caster.reach);
        if (count > 0) {
            for (const Edge& edge : caster.outline) {
                measureFrom(edge, caster.reach, nearest);
            }
        }
    }

    void measureFrom(const Edge& edge, float reach, Nearest& nearest) const {
        const glm::vec2 low = glm::min(edge.a, edge.b) - reach;
        const glm::vec2 high = glm::max(edge.a, edge.b) + reach;
        const Run rows = cornersWithin(low.y, high.y, m_origin.y, nearest.rows);
        const Run columns = cornersWithin(low.x, high.x, m_origin.x, nearest.columns);
        for (std::uint32_t row = rows.first; row < rows.end; ++row) {
            measureRow(edge, {xOf(columns.first), yOf(row)}, m_cell,
                       nearest.rowAt(row).subspan(columns.first - nearest.columns.first, columns.end - columns.first));
        }
    }

    /// Of corners from `first` to the right. Squares of distances and no branches, so that the compiler takes several
    /// corners at once.
    static void measureRow(const Edge& edge, glm::vec2 first, float cell, std::span<float> squares) {
        const glm::vec2 extent = edge.b - edge.a;
        const float length = glm::length(extent);
        const glm::vec2 along = length > 0.0F ? extent / length : glm::vec2(1.0F, 0.0F);
        const glm::vec2 start = first - 0.5F * (edge.a + edge.b);
        for (std::size_t i = 0; i < squares.size(); ++i) {
            const float x = start.x + cell * static_cast<float>(static_cast<int>(i));
            const float beside = x * along.y - start.y * along.x;
            const float signedBeyond = std::abs(x * along.x + start.y * along.y) - 0.5F * length;
            const float beyond = 0.5F * (signedBeyond + std::abs(signedBeyond));  // 0 where it is negative
            squares[i] = std::min(squares[i], beside * beside + beyond * beyond);
        }
    }

    void darkenRows(const Caster& caster, const Run& within, Nearest& nearest) {
        measure(caster, within, nearest);
        for (std::uint32_t row = nearest.rows.first; row < nearest.rows.end; ++row) {
            darkenAround(caster, row, nearest);
            darkenUnder(caster, row);
        }
    }

    void darkenAround(const Caster& caster, std::uint32_t row, Nearest& nearest) {
        std::uint8_t* value = rowAt(row) + nearest.columns.first;
        for (const float square : nearest.rowAt(row)) {
            const float rest = std::max(1.0F - std::sqrt(square) / caster.reach, 0.0F);
            *value = std::max(*value, static_cast<std::uint8_t>(kDark * rest * rest + 0.5F));
            ++value;
        }
    }

    /// Inside by the even-odd rule.
    void darkenUnder(const Caster& caster, std::uint32_t row) {
        const float y = yOf(row);
        std::vector<float> crossings;
        for (const Edge& edge : caster.outline) {
            if ((edge.a.y <= y) != (edge.b.y <= y)) {
                crossings.push_back(edge.a.x + (y - edge.a.y) / (edge.b.y - edge.a.y) * (edge.b.x - edge.a.x));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const Run columns = cornersWithin(crossings[i], crossings[i + 1], m_origin.x, insideRim());
            std::fill(rowAt(row) + columns.first, rowAt(row) + columns.end, static_cast<std::uint8_t>(kDark));
        }
    }

    std::vector<Caster> m_casters;
    glm::vec2 m_origin{0.0F};
    float m_cell = 1.0F;
    std::uint32_t m_width = 0;  ///< corners
    std::uint32_t m_height = 0;
    std::vector<std::uint8_t> m_values;
};

ShadowMap mapOf(const BoardModel& model, std::uint32_t growth) {
    std::vector<Caster> casters = castersOf(model, growth);
    const Box2 cover = coverOf(model, casters);
    if (cover.min.x >= cover.max.x || cover.min.y >= cover.max.y) {
        return {};
    }
    Corners corners(cover, std::move(casters));
    corners.darken();
    return corners.map();
}

}  // namespace

BodyShadows castShadows(const BoardModel& model) {
    return {mapOf(model, shader::kLayerGrowsUp), mapOf(model, shader::kLayerGrowsDown)};
}

}  // namespace render
