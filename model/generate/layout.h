#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

/// Boards made up to measure: the element counts of the paper's Table 3, laid out like a board and written as an ODB++
/// job (job_writer.h), or as a text model with curves (model_writer.h). Here is where their elements lie. Arithmetic
/// only: a block is worked out whenever it is requested, so that a board of millions of elements needs no memory.
namespace model::generate {

/// Elements by kind, in the order of model::ElementKind: line, arc, circle, trail, area.
using Counts = std::array<std::uint64_t, 5>;

/// A row of the paper's Table 3. `tracksPerTrail` is ours: with it, and with the paper's fixed segments, a generated
/// board has about the number of triangles that Table 2 gives for the row.
struct PaperModel {
    std::string_view name;
    Counts counts;
    int tracksPerTrail = 0;
};

[[nodiscard]] const PaperModel* findPaperModel(std::string_view name);  ///< null if there is none

/// Micrometres: the finest that the job's text needs three decimals of a millimetre for.
struct PointUm {
    std::int32_t x = 0;
    std::int32_t y = 0;
    constexpr bool operator==(const PointUm&) const = default;
};

/// The layers of the job that hold features.
enum class BoardLayer : std::uint8_t { Silk, Top, Ground, Power, Bottom, Drill };
inline constexpr std::size_t kLayerCount = 6;

/// Whom a feature belongs to: a net of its block (0, 1, …), a plane's net or none.
using BlockNet = std::int32_t;
inline constexpr BlockNet kNoNet = -1;
inline constexpr BlockNet kGroundNet = -2;
inline constexpr BlockNet kPowerNet = -3;

/// Rows of the symbol table that every features file of the job starts with.
enum class Pen : std::uint8_t { Trace, Mark, ViaPad, TestPad, Drill, PadSmall, PadMiddle, PadLarge };

/// One feature record. A run of tracks that start where the one before ends is a trail.
struct Feature {
    enum class Kind : std::uint8_t { Track, Arc, Pad } kind = Kind::Pad;
    Pen pen = Pen::Trace;
    BlockNet net = kNoNet;
    PointUm a;
    PointUm b;       ///< end of a track or an arc
    PointUm centre;  ///< of an arc, which runs clockwise
};

/// A rectangle of the board with a few parts: two rows of pads on either side, vias between them, traces, print.
struct Block {
    std::array<std::vector<Feature>, kLayerCount> features;
    std::int32_t netCount = 0;
    std::vector<PointUm> viasNotOnGround;  ///< what the planes keep clear of
    std::vector<PointUm> viasNotOnPower;
};

/// A copper plane below a tile of blocks, on both plane layers.
struct Tile {
    PointUm min;
    PointUm max;
    std::vector<std::uint64_t> blocks;
};

struct Wanted {
    Counts counts{};
    int tracksPerTrail = 3;
    std::uint64_t seed = 1;
};

/// Shares the wanted elements out evenly among as many blocks as they need.
class Layout {
public:
    explicit Layout(const Wanted& wanted);

    [[nodiscard]] std::uint64_t blockCount() const { return m_blocks; }
    [[nodiscard]] Block block(std::uint64_t index) const;
    [[nodiscard]] std::uint64_t tileCount() const { return m_tilesWithPour; }
    [[nodiscard]] Tile tile(std::uint64_t index) const;
    /// Corners of the board, around 0,0.
    [[nodiscard]] PointUm min() const;
    [[nodiscard]] PointUm max() const;
    /// Whether the board fits in the coordinates a job may use (base::kMaxCoordinate).
    [[nodiscard]] bool fits() const;

    static constexpr std::int32_t kViaClearanceUm = 250;  ///< radius of the hole in a plane

private:
    [[nodiscard]] std::uint64_t share(std::uint64_t total, std::uint64_t block) const;
    [[nodiscard]] PointUm cornerOf(std::uint64_t block) const;

    Wanted m_wanted;
    std::uint64_t m_blocks = 1;
    std::uint64_t m_columns = 1;
    std::uint64_t m_rows = 1;
    std::uint64_t m_tileColumns = 1;
    std::uint64_t m_tilesWithPour = 0;
    std::uint64_t m_pads = 0;
};

}  // namespace model::generate
