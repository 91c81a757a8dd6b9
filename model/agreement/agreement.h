#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/agreement/region_difference.h"
#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"

/// Whether two jobs describe the same board, whatever formats they are written in.
namespace model {

/// What is compared.
enum class Aspect : std::uint8_t {
    Copper,
    SolderMask,
    SolderPaste,
    Silkscreen,
    Outline,
    Holes,     ///< location and size within 1 µm (slots: two pixels), plating, the copper they pass
    Parts,     ///< by reference designator: location within 1 µm, side, rotation
    Pins,      ///< of the parts that both have: name, where both name it, and location within 1 µm
    Nets,      ///< pins and pads that are one net in one job are one net in the other
    NetNames,  ///< nets of the same pins and pads have the same name
    Stackup    ///< thicknesses of copper, of the dielectric between, and of both together
};
inline constexpr std::size_t kAspectCount = 11;
[[nodiscard]] const char* toString(Aspect aspect);  ///< "copper", "solder-mask", … "stackup"
[[nodiscard]] std::optional<Aspect> aspectNamed(std::string_view name);

enum class Accord : std::uint8_t {
    Agree,
    Differ,
    NotCompared  ///< one of the jobs does not say; Comparison::note tells
};
[[nodiscard]] const char* toString(Accord accord);  ///< "agree", "differ", "not_compared"

struct Difference {
    std::string text;                 ///< "R5 is on the bottom in A and on the top in B"
    std::optional<Point> location{};  ///< in the coordinates of the first job
    Box box{};                        ///< likewise, of layers and outlines: around what differs there; else empty
};

/// Layers of two boards that are the same layer; one of them is none where only one board has it.
struct LayerPair {
    Aspect aspect = Aspect::Copper;
    LayerId a;
    LayerId b;
};

/// One aspect, or one layer of it.
struct Comparison {
    Aspect aspect = Aspect::Copper;
    Accord accord = Accord::Agree;
    LayerPair pair{};                          ///< of layers
    std::array<std::string, 2> layers;         ///< their names; empty where there is none
    std::array<std::size_t, 2> counts{};       ///< how many holes, parts, pins, nets or copper layers either job has
    std::optional<RegionDifference> region{};  ///< of layers and outlines; a difference for each of its places
    std::string note{};
    std::optional<double> farthest{};       ///< of holes, parts and pins: largest distance between two of a pair, nm
    std::size_t differing = 0;              ///< how many differences there are
    std::vector<Difference> differences{};  ///< the first of them

    /// Counts it, and keeps it if it is one of the first `most`.
    void add(Difference difference, std::size_t most);
    /// Takes the locations of a pair into `farthest`.
    void measure(Point a, Point b);
};

struct AgreementRequest {
    /// Length of a pixel: what differs between two layers counts where it is wider than about three of them.
    Nm tolerance = 10'000;
    double allowed = 0.0;           ///< share of a layer's area that may differ and still agree
    std::size_t most = 10;          ///< how many differences are kept of each comparison
    std::vector<Aspect> aspects{};  ///< only these; empty: all
    [[nodiscard]] bool wants(Aspect aspect) const;
};

struct Agreement {
    Point shift;  ///< added to coordinates of the second job: the two may count from different origins
    std::vector<Comparison> comparisons;

    /// Was anything compared?
    [[nodiscard]] bool isCompared() const;
    /// What could not be compared does not count; nothing compared is no agreement.
    [[nodiscard]] bool isAgreed() const;
};

/// Compares two boards, copies of steps included. Layers are paired by type, side and order, where these are not enough
/// by name; documents and other layers that formats do not share are left out. The second job is shifted by the
/// difference of the boards' lower left corners if more of its holes then lie on those of the first. Parts without pins
/// that only one job has are noted and no difference: some formats have no place for them. So are parts that state
/// another rotation while all their pins lie at the same locations: it depends on how formats draw
/// packages. Of parts that one of the jobs does not place (Gerber without a pick-and-place file) sides and pins are
/// compared, and a note counts them; the side is not where all they have are pins through the board. Pads without a
/// number that are pins in one job only are noted, too. Errors: Cancelled.
[[nodiscard]] base::Result<Agreement> compareBoards(const Document& a, const Document& b,
                                                    const AgreementRequest& request, base::Progress& progress);

}  // namespace model
