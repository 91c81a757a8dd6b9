#include "render/modelling/let_tables.h"

#include <span>

#include "model/base/assert.h"

namespace render {
namespace {

using shader::kIntervalTriangles;

/// Writes the indices of one topology and level.
class TableMaker {
public:
    TableMaker(std::uint32_t topology, std::uint32_t level, std::vector<std::uint32_t>& out)
        : m_topology(topology), m_level(level), m_intervals(shader::ladderIntervals(topology, level)), m_out(out) {}

    LetTable make() {
        LetTable table;
        table.first = size();
        table.counts[0] = intervals(0, shader::kUpperTriangles);
        table.counts[1] = m_level == shader::kLevelFlat ? 0 : walls();
        table.counts[2] = intervals(shader::kUpperTriangles + shader::kWallTriangles, shader::kUpperTriangles);
        return table;
    }

private:
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(m_out.size()); }

    /// Corner `digit` of a triangle whose ladder interval starts at `segment`; the last segment of a closed ladder
    /// leads to its first.
    [[nodiscard]] std::uint32_t index(std::uint32_t segment, std::uint32_t digit) const {
        const std::uint32_t own = (segment + digit / 4) % (m_topology == shader::kTopologyClosed ? m_intervals : ~0U);
        return (m_level << shader::kIndexLevelShift) | (own * 4 + digit % 4);
    }

    void triangle(std::uint32_t segment, std::uint32_t digits) {
        for (const std::uint32_t shift : {8U, 4U, 0U}) {
            m_out.push_back(index(segment, (digits >> shift) & 0xfU));
        }
    }

    std::uint32_t intervals(std::uint32_t first, std::uint32_t count) {
        const std::uint32_t before = size();
        for (std::uint32_t segment = 0; segment < m_intervals; ++segment) {
            for (std::uint32_t i = first; i < first + count; ++i) {
                triangle(segment, kIntervalTriangles[i]);
            }
        }
        return size() - before;
    }

    std::uint32_t walls() {
        const std::uint32_t count = intervals(shader::kUpperTriangles, shader::kWallTriangles);
        if (m_topology == shader::kTopologyClosed) {
            return count;
        }
        for (std::uint32_t i = 0; i < shader::kEndTriangleCount; ++i) {
            triangle(0, shader::kFirstEndTriangles[i]);
            triangle(m_intervals, shader::kLastEndTriangles[i]);
        }
        return count + 2 * shader::kEndTriangleCount * 3;
    }

    std::uint32_t m_topology;
    std::uint32_t m_level;
    std::uint32_t m_intervals;
    std::vector<std::uint32_t>& m_out;
};

/// So many quads, face after face.
LetTable groupOf(const LetTable& quad, std::vector<std::uint32_t>& indices) {
    LetTable group;
    group.first = static_cast<std::uint32_t>(indices.size());
    std::uint32_t from = quad.first;
    for (std::size_t section = 0; section < quad.counts.size(); ++section) {
        for (std::uint32_t nth = 0; nth < shader::kQuadGroup; ++nth) {
            for (std::uint32_t i = from; i < from + quad.counts[section]; ++i) {
                indices.push_back(indices[i] | shader::kIndexGrouped | nth << shader::kIndexQuadShift);
            }
        }
        group.counts[section] = quad.counts[section] * shader::kQuadGroup;
        from += quad.counts[section];
    }
    return group;
}

}  // namespace

IndexRun LetTables::run(std::uint32_t draw, SeenFaces faces) const {
    const bool isFlat = draw == shader::kDrawOfRest || draw % shader::kLevelCount >= shader::kLevelFlat;
    return runOf(tables[draw], isFlat ? SeenFaces{faces.upper, false, !faces.upper} : faces);
}

IndexRun LetTables::runOf(const LetTable& table, SeenFaces faces) {
    const auto [upper, walls, lower] = table.counts;
    const std::uint32_t skipped = (faces.upper ? 0 : upper) + (faces.upper || faces.walls ? 0 : walls);
    const std::uint32_t count = (faces.upper ? upper : 0) + (faces.walls ? walls : 0) + (faces.lower ? lower : 0);
    return {table.first + skipped, count};
}

LetTables makeLetTables() {
    LetTables result;
    for (std::uint32_t topology = 0; topology < shader::kTopologyCount; ++topology) {
        for (std::uint32_t level = 0; level < shader::kLevelCount; ++level) {
            result.tables[topology * shader::kLevelCount + level] = TableMaker(topology, level, result.indices).make();
        }
    }
    result.tables[shader::kDrawOfRest] = result.tables[shader::kLevelQuad];
    result.tables[shader::kLevelQuad] = groupOf(result.tables[shader::kDrawOfRest], result.indices);
    return result;
}

}  // namespace render
