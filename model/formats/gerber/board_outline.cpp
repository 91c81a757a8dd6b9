#include "model/formats/gerber/board_outline.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "model/formats/gerber/outline.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

namespace {

using formats::DrawnFeature;
using formats::DrawnKind;
using Kind = FileRole::Kind;

/// What is drawn with more lines than this by one pen is no outline.
constexpr std::size_t kMostOutlineTracks = 20'000;
/// Outlines of two films are the same within this.
constexpr Nm kSameOutline = 20'000;
/// Of pads that an outline encloses: edge connectors and test coupons may lie outside.
constexpr Nm kBeyondOutline = 100'000;

double areaOf(const Box& box) {
    return static_cast<double>(box.width()) * static_cast<double>(box.height());
}

bool isAround(const Box& outer, const Box& inner) {
    return !outer.isEmpty() && outer.holds(inner.min) && outer.holds(inner.max);
}

bool isSame(const Box& a, const Box& b) {
    return isAround(a.grownBy(kSameOutline), b) && isAround(b.grownBy(kSameOutline), a);
}

/// What a film draws with each of its pens, lines and arcs only.
class Pens {
public:
    explicit Pens(const Image& image) {
        for (const DrawnFeature& feature : image.features) {
            if (feature.kind == DrawnKind::Line || feature.kind == DrawnKind::Arc) {
                Pen& pen = m_pens[feature.symbol];
                pen.box.include(feature.a);
                pen.box.include(feature.b);
                ++pen.tracks;
            }
        }
    }

    /// The symbols of pens that draw around a box, and are not busy with other things.
    [[nodiscard]] std::vector<std::int32_t> around(const Box& box) const {
        std::vector<std::int32_t> symbols;
        for (const auto& [symbol, pen] : m_pens) {
            if (pen.tracks <= kMostOutlineTracks && isAround(pen.box.grownBy(kBeyondOutline), box)) {
                symbols.push_back(symbol);
            }
        }
        return symbols;
    }

private:
    struct Pen {
        Box box;
        std::size_t tracks = 0;
    };
    std::map<std::int32_t, Pen> m_pens;
};

Image drawnWith(std::int32_t symbol, const Image& image) {
    Image drawn;
    std::ranges::copy_if(image.features, std::back_inserter(drawn.features), [symbol](const DrawnFeature& feature) {
        return feature.symbol == symbol && (feature.kind == DrawnKind::Line || feature.kind == DrawnKind::Arc);
    });
    return drawn;
}

/// Of what a drawing or film shows the loop around the copper, with the loops within it as cut-outs unless some hold
/// copper: then they are outlines of parts, as assembly drawings have them.
Outline withoutParts(const Outline& outline) {
    Outline board;
    for (std::size_t i = 0; i < outline.shape.contourCount(); ++i) {
        const PathNodes nodes = outline.shape.contour(i);
        const Box box = boxOfPath(nodes, true);
        const bool isCutout = outline.shape.isHole(i) && !outline.isDrawing && isAround(board.box, box);
        if (i == 0 || isCutout) {
            board.shape.beginContour(i != 0);
            board.shape.addNodes(nodes);
            board.box.include(box);
        }
    }
    return board;
}

class OutlineFinder {
public:
    OutlineFinder(std::span<const ReadFile> files, const BoardFiles& board, const CopperPlaces& copper,
                  Diagnostics& diagnostics)
        : m_files(files), m_board(board), m_copper(copper), m_diagnostics(diagnostics) {
        for (const Point& pad : copper.pads) {
            m_padBox.include(pad);
        }
    }

    std::optional<BoardOutline> run() {
        findNamed();
        const bool isCertain = m_named && m_named->isCertain;
        std::optional<BoardOutline> best = isCertain ? std::nullopt : ofDrawings();
        if (!best && m_named) {
            report(*m_named->file, m_named->outline);
            best = BoardOutline{std::move(m_named->outline.shape), m_named->file->path};
        }
        for (const Named& open : m_named ? std::vector<Named>() : m_open) {
            report(*open.file, open.outline);
        }
        return best ? std::move(best) : ofFilms();
    }

private:
    /// An outline of a file that is said to draw the board's.
    struct Named {
        Outline outline;
        const ReadFile* file = nullptr;
        bool isCertain = false;  ///< by more than its name, or as it encloses all pads
    };

    /// The first file that certainly draws the outline, else the first that may: "board_dimension" and "board_outline"
    /// can be drawings of anything.
    void findNamed() {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (!isDrawn(file) || file.role.kind != Kind::Profile) {
                continue;
            }
            Named named{outlineOf(file.image, m_copper.pads, true), &file, file.role.source < RoleSource::Name};
            if (named.outline.shape.isEmpty() || !mayBe(named.outline.box)) {
                m_open.push_back(std::move(named));
                continue;
            }
            const Box& within = m_padBox.isEmpty() ? m_copper.box : m_padBox;
            named.isCertain = named.isCertain || isAround(named.outline.box.grownBy(kBeyondOutline), within);
            if (named.isCertain || !m_named) {
                m_named = std::move(named);
            }
            if (m_named->isCertain) {
                return;
            }
        }
    }

    std::optional<BoardOutline> ofDrawings() {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (!isDrawn(file) || (file.role.kind != Kind::Document && file.role.kind != Kind::Unknown)) {
                continue;
            }
            Outline outline = withoutParts(outlineOf(file.image, m_copper.pads));
            if (!outline.shape.isEmpty() && fits(outline.box)) {
                assume(file.path, "taken from this one, whose loops enclose the copper closely");
                return BoardOutline{std::move(outline.shape), file.path};
            }
        }
        return std::nullopt;
    }

    /// A loop around the copper that a film draws beside its own things.
    struct Frame {
        Outline outline;
        const ReadFile* file = nullptr;
    };

    std::optional<BoardOutline> ofFilms() {
        std::vector<Frame> frames;
        for (const std::size_t row : m_board.files) {
            if (isFilm(m_files[row])) {
                addFrames(m_files[row], frames);
            }
        }
        // The film that draws least within the loop has the fewest loops that are none of the board's.
        std::ranges::stable_sort(frames, {}, [](const Frame& frame) { return frame.outline.shape.contourCount(); });
        for (Frame& frame : frames) {
            const bool isAlike = std::ranges::any_of(frames, [&](const Frame& other) {
                return other.file->role.kind != frame.file->role.kind && isSame(other.outline.box, frame.outline.box);
            });
            if (isAlike || frame.file->role.kind == Kind::Legend) {
                assume(frame.file->path,
                       isAlike ? "taken from the loop around the pads that this film and others draw alike"
                               : "taken from the loop around the pads that the silkscreen draws");
                return BoardOutline{std::move(frame.outline.shape), frame.file->path};
            }
        }
        return std::nullopt;
    }

    void addFrames(const ReadFile& film, std::vector<Frame>& frames) const {
        for (const std::int32_t symbol : Pens(film.image).around(m_padBox)) {
            Outline outline = withoutParts(outlineOf(drawnWith(symbol, film.image), m_copper.pads));
            if (!outline.shape.isEmpty() && enclosesPads(outline.box)) {
                frames.push_back({std::move(outline), &film});
            }
        }
    }

    [[nodiscard]] static bool isDrawn(const ReadFile& file) {
        return file.isImage() && file.kind == ReadFile::Kind::Gerber;
    }
    [[nodiscard]] static bool isFilm(const ReadFile& file) {
        const Kind kind = file.role.kind;
        return isDrawn(file) &&
               (kind == Kind::Copper || kind == Kind::SolderMask || kind == Kind::Paste || kind == Kind::Legend);
    }

    /// Not a symbol in a corner of a drawing.
    [[nodiscard]] bool mayBe(const Box& box) const {
        return m_copper.box.isEmpty() ||
               (box.width() * 2 > m_copper.box.width() && box.height() * 2 > m_copper.box.height());
    }

    /// Encloses the copper, or at least all pads where films have marks outside of the board, and not much more.
    [[nodiscard]] bool fits(const Box& box) const { return encloses(box, m_copper.box) || enclosesPads(box); }
    [[nodiscard]] bool enclosesPads(const Box& box) const { return encloses(box, m_padBox); }
    [[nodiscard]] static bool encloses(const Box& box, const Box& copper) {
        return !copper.isEmpty() && isAround(box.grownBy(kBeyondOutline), copper) &&
               areaOf(box) < 2.0 * areaOf(copper) + 1e12;
    }

    void report(const ReadFile& file, const Outline& outline) {
        for (const std::string& gaps : outline.gaps) {
            m_diagnostics.report(Severity::Warning, file.path, 0, gaps);
        }
        if (outline.openTracks > 0) {
            m_diagnostics.report(Severity::Warning, file.path, 0,
                                 "some lines of the board's outline do not close; they are left out of it");
        }
        if (outline.isDrawing) {
            m_diagnostics.report(
                Severity::Warning, file.path, 0,
                "loops within the board's outline hold copper, or are too many for cut-outs; they were "
                "taken for a drawing");
        }
        if (outline.widestJoint > 1'000) {
            m_diagnostics.report(Severity::Info, file.path, 0,
                                 "lines of the board's outline do not meet exactly; they were joined");
        }
    }

    /// `what`: how the sentence goes on that says why no named file has the outline.
    void assume(const std::string& path, const char* what) {
        const char* why = m_named ? "the file that is named as the board's outline does not enclose all pads; "
                          : m_open.empty()
                              ? "no file is named as the board's outline; "
                              : "the file that is named as the board's outline draws no closed loop of its "
                                "size; ";
        m_diagnostics.report(Severity::Info, path, 0, std::string(why) + what);
    }

    std::span<const ReadFile> m_files;
    const BoardFiles& m_board;
    const CopperPlaces& m_copper;
    Diagnostics& m_diagnostics;
    Box m_padBox;
    std::optional<Named> m_named;
    std::vector<Named> m_open;  ///< said to draw the outline, but with no loop that may be one
};

}  // namespace

std::optional<BoardOutline> findOutline(std::span<const ReadFile> files, const BoardFiles& board,
                                        const CopperPlaces& copper, Diagnostics& diagnostics) {
    return OutlineFinder(files, board, copper, diagnostics).run();
}

}  // namespace model::gerber
