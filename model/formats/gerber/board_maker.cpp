#include "model/formats/gerber/board_maker.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "model/formats/gerber/board_outline.h"
#include "model/formats/gerber/drill_fitting.h"
#include "model/formats/gerber/drills/drill_functions.h"
#include "model/formats/gerber/layer_order.h"
#include "model/formats/gerber/missing_layers.h"
#include "model/formats/gerber/naming/drill_spans.h"
#include "model/formats/gerber/pad_nets.h"
#include "model/formats/gerber/parts.h"
#include "model/formats/gerber/region_middle.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;
using formats::kNoRow;

namespace {

class BoardMaker {
public:
    BoardMaker(std::vector<ReadFile>& files, const BoardFiles& board, const std::string& jobName)
        : m_files(files), m_board(board), m_jobName(jobName), m_nets(m_step), m_parts(m_step) {}

    MadeBoard run() {
        findJobFile();
        indexCopper();
        readDrillsAgain();
        m_layers = orderedLayers(m_files, m_board, m_job, m_result.job.diagnostics);
        reportMissingLayers(m_files, m_board, diagnostics());
        findBoardOutline();
        m_step.features.resize(m_layers.layers.size());
        for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
            if (m_layers.files[layer] != kNoRow) {
                addImage(layer, m_files[static_cast<std::size_t>(m_layers.files[layer])]);
            }
        }
        addX3Components();
        PadNets(m_step, m_layers, m_parts, m_nets, diagnostics()).run(m_files, m_board, m_result.hasNets);
        placeComponents();
        setSpans();
        setBackDrills();
        finish();
        return std::move(m_result);
    }

private:
    Diagnostics& diagnostics() { return m_result.job.diagnostics; }

    void findJobFile() {
        for (const std::size_t row : m_board.files) {
            if (m_files[row].kind == ReadFile::Kind::Job) {
                m_job = m_files[row].job;
            }
        }
    }

    [[nodiscard]] bool isCopper(std::size_t row) const {
        return m_files[row].isImage() && m_files[row].role.kind == FileRole::Kind::Copper;
    }

    [[nodiscard]] bool isNegative(std::size_t row) const {
        return m_files[row].role.isNegative != m_files[row].image.isNegative;
    }

    /// Flashes of copper, which holes and netlists are matched with. Negatives draw where there is none, and frames far
    /// beyond the board; they count where there is nothing else.
    void indexCopper() {
        const bool hasPositive =
            std::ranges::any_of(m_board.files, [&](std::size_t row) { return isCopper(row) && !isNegative(row); });
        std::vector<IndexedPad> pads;
        for (const std::size_t row : m_board.files) {
            if (!isCopper(row) || (hasPositive && isNegative(row))) {
                continue;
            }
            for (const DrawnFeature& feature : m_files[row].image.features) {
                if (feature.kind == DrawnKind::Region) {
                    m_copperBox.include(boxOf(m_files[row].image.regions[static_cast<std::size_t>(feature.region)]));
                } else {
                    m_copperBox.include(feature.a);
                }
                if (feature.kind == DrawnKind::Pad) {
                    pads.push_back({feature.a, static_cast<std::int32_t>(row), 0});
                }
            }
        }
        m_filePads = PadIndex(std::move(pads));
    }

    /// Holes of blind and buried vias may lie on each other.
    [[nodiscard]] bool haveOtherSpans(const ReadFile& a, const ReadFile& b) const {
        const LayerPair* const ofA = pairOf(a);
        const LayerPair* const ofB = pairOf(b);
        const bool areTold = a.role.spanTop > 0 && b.role.spanTop > 0;
        return (areTold && (a.role.spanTop != b.role.spanTop || a.role.spanBottom != b.role.spanBottom)) ||
               spanInName(a.name()) != spanInName(b.name()) ||
               (ofA != nullptr && ofB != nullptr && ofA->endings != ofB->endings);
    }

    /// What an export of layer pairs says of a file of drills; nullptr if nothing.
    [[nodiscard]] const LayerPair* pairOf(const ReadFile& file) const {
        for (const std::size_t row : m_board.files) {
            for (const LayerPair& pair : m_files[row].layerPairs) {
                if (equalsIgnoringCase(pair.drillFile, file.name())) {
                    return &pair;
                }
            }
        }
        return nullptr;
    }

    /// Of the first file that tells where the drills count from; the others count from there, too.
    [[nodiscard]] std::optional<Point> shiftOfDrills() const {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            const std::optional<Point> shift =
                file.isImage() && isOfHoles(file) ? originShift(file, m_filePads, m_copperBox) : std::nullopt;
            if (shift) {
                return shift;
            }
        }
        return std::nullopt;
    }

    void fitDrills() {
        const std::optional<Point> shift = shiftOfDrills();
        std::optional<CoordinateFormat> sibling;
        std::vector<std::size_t> beside;
        for (const std::size_t row : m_board.files) {
            ReadFile& file = m_files[row];
            if (!file.isImage() || !isOfHoles(file) || (shift && moveHoles(file, *shift, m_copperBox))) {
                continue;
            }
            if (!fitToCopper(file, m_filePads, m_copperBox)) {
                beside.push_back(row);
            } else if (file.kind == ReadFile::Kind::Drills && !file.image.features.empty()) {
                sibling = sibling.value_or(file.format);
            }
        }
        for (const std::size_t row : beside) {
            fitAsSibling(m_files[row], sibling, m_copperBox);
        }
    }

    /// Those that say what is plated first.
    [[nodiscard]] std::vector<std::size_t> filesOfHoles() const {
        std::vector<std::size_t> rows;
        std::ranges::copy_if(m_board.files, std::back_inserter(rows),
                             [&](std::size_t row) { return m_files[row].isImage() && isOfHoles(m_files[row]); });
        std::stable_partition(rows.begin(), rows.end(),
                              [&](std::size_t row) { return m_files[row].role.plating != Plating::NotSaid; });
        return rows;
    }

    /// Drills of another board, which were left beside those of this one.
    void reportStrangers(const std::vector<std::size_t>& rows) {
        const auto share = [&](std::size_t row) {
            const FileRole& role = m_files[row].role;
            const bool mayMeet = role.kind == FileRole::Kind::Drill && role.plating != Plating::NonPlated;
            return mayMeet ? shareOnPads(m_files[row].image, m_filePads) : std::nullopt;
        };
        std::vector<std::optional<double>> shares;
        std::ranges::transform(rows, std::back_inserter(shares), share);
        const bool isAnyOnPads = std::ranges::any_of(shares, [](const std::optional<double>& of) { return of > 0.8; });
        for (std::size_t i = 0; i < rows.size() && isAnyOnPads; ++i) {
            if (shares[i] && *shares[i] < 0.1) {
                const std::size_t row = rows[i];
                m_files[row].diagnostics.report(Severity::Warning, m_files[row].path, 0,
                                                "hardly a hole of the file meets a pad, as those of another one do; it "
                                                "may be of another board");
            }
        }
    }

    void readDrillsAgain() {
        fitDrills();
        const std::vector<std::size_t> rows = filesOfHoles();
        reportStrangers(rows);
        std::vector<std::size_t> seen;
        for (const std::size_t row : rows) {
            ReadFile& file = m_files[row];
            std::vector<const Image*> others;
            for (const std::size_t other : seen) {
                if (!haveOtherSpans(m_files[other], file)) {
                    others.push_back(&m_files[other].image);
                }
            }
            if (file.role.source == RoleSource::Told || !drillOnce(others, file)) {
                seen.push_back(row);
            }
        }
    }

    // ---- images ----

    /// How rows of an image become rows of the step.
    struct Rows {
        std::int32_t symbols = 0;
        std::int32_t regions = 0;
        std::int32_t attributes = 0;
        std::vector<std::int32_t> nets;
        std::vector<std::int32_t> components;
    };

    Rows takeTables(Image& image) {
        Rows rows{static_cast<std::int32_t>(m_step.symbols.size()),
                  static_cast<std::int32_t>(m_step.regions.size()),
                  static_cast<std::int32_t>(m_step.attributes.size()),
                  {},
                  {}};
        std::ranges::move(image.symbols, std::back_inserter(m_step.symbols));
        std::ranges::move(image.regions, std::back_inserter(m_step.regions));
        std::ranges::move(image.attributes, std::back_inserter(m_step.attributes));
        for (const std::string& net : image.nets) {
            rows.nets.push_back(net == "N/C" ? kNoRow : m_nets.row(net));
            m_result.hasNets = true;  // N/C says that there is none
        }
        for (const std::string& refdes : image.components) {
            rows.components.push_back(m_parts.component(refdes));
        }
        return rows;
    }

    static bool isOfHoles(const ReadFile& file) {
        return file.role.kind == FileRole::Kind::Drill || file.role.kind == FileRole::Kind::Rout;
    }

    void addImage(std::size_t layer, ReadFile& file) {
        Image& image = file.image;
        if (isOfHoles(file)) {
            plateByFunction(image);
            m_backDrills.emplace_back(layer, backDrillsIn(image));
        }
        const Rows rows = takeTables(image);
        const bool isCopperLayer = file.role.kind == FileRole::Kind::Copper;
        const LayerSide side = m_layers.layers[layer].side;
        const Plating plating = file.role.plating;
        for (DrawnFeature& feature : image.features) {
            feature.symbol += feature.symbol >= 0 ? rows.symbols : 0;
            feature.region += feature.region >= 0 ? rows.regions : 0;
            feature.attributes += feature.attributes >= 0 ? rows.attributes : 0;
            feature.net = feature.net >= 0 ? rows.nets[static_cast<std::size_t>(feature.net)] : kNoRow;
            settlePin(feature, image, rows, isCopperLayer, side);
            if (feature.plating == Plating::NotSaid) {
                feature.plating = plating;
            }
        }
        m_step.features[layer] = std::move(image.features);
    }

    /// Objects of components are pads of pins only on copper.
    void settlePin(DrawnFeature& feature, const Image& image, const Rows& rows, bool isCopperLayer, LayerSide side) {
        if (feature.component < 0) {
            return;
        }
        const std::int32_t component = rows.components[static_cast<std::size_t>(feature.component)];
        const bool isPad = isCopperLayer && feature.pin >= 0 && feature.kind == DrawnKind::Pad;
        const bool isThrough =
            feature.attributes >= 0 &&
            std::ranges::any_of(m_step.attributes[static_cast<std::size_t>(feature.attributes)], [](const auto& word) {
                return word.first == ".AperFunction" && word.second.starts_with("ComponentPad");
            });
        m_parts.isSeenOn(component, side, isPad, isPad && isThrough);
        feature.component = kNoRow;
        if (isCopperLayer && feature.pin >= 0) {
            const ImagePin& pin = image.pins[static_cast<std::size_t>(feature.pin)];
            const Point at = feature.kind == DrawnKind::Region
                                 ? middleOfPad(m_step.regions[static_cast<std::size_t>(feature.region)])
                                 : feature.a;
            feature.component = component;
            feature.pin = m_parts.pin(component, pin.name, at, feature.net);
        } else {
            feature.pin = kNoRow;
        }
    }

    // ---- components ----

    /// X3 component layers: flashes at the places of components.
    void addX3Components() {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (file.isImage() && file.role.kind == FileRole::Kind::Components) {
                PlacementFile placed;
                placed.isOnImages = true;
                for (const DrawnFeature& feature : file.image.features) {
                    addX3(file, feature, placed);
                }
                m_parts.place(placed, file.path, m_filePads, m_copperBox, diagnostics());
            }
        }
    }

    /// When all pins are known, also those that only a netlist names: they tell where a pick-and-place file counts
    /// from.
    void placeComponents() {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (file.kind == ReadFile::Kind::Placements) {
                m_parts.place(file.placements, file.path, m_filePads, m_copperBox, diagnostics());
            }
        }
    }

    void addX3(const ReadFile& file, const DrawnFeature& feature, PlacementFile& placed) {
        if (feature.kind != DrawnKind::Pad || feature.component < 0) {
            return;
        }
        const std::string& refdes = file.image.components[static_cast<std::size_t>(feature.component)];
        if (feature.pin >= 0) {
            const std::int32_t component = m_parts.component(refdes);
            (void)m_parts.pin(
                component, file.image.pins[static_cast<std::size_t>(feature.pin)].name, feature.a,
                feature.net < 0 ? kNoRow : m_nets.row(file.image.nets[static_cast<std::size_t>(feature.net)]));
            return;
        }
        PlacedPart part;
        part.refdes = refdes;
        part.position = base::toDouble(feature.a);
        part.side = file.role.side;
        part.line = feature.line;
        const formats::Words none;
        const formats::Words& words =
            feature.attributes < 0 ? none : file.image.attributes[static_cast<std::size_t>(feature.attributes)];
        for (const auto& [name, value] : words) {
            if (name == ".CRot") {
                part.rotationDeg = fromFlipAlongX(parseReal(value).value_or(0.0), part.side);
            } else if (name == ".CVal") {
                part.value = value;
            } else if (name == ".CFtp") {
                part.package = value;
            }
        }
        placed.parts.push_back(std::move(part));
    }

    // ---- outline, spans, names ----

    void findBoardOutline() {
        std::vector<Point> pads;
        for (const IndexedPad& pad : m_filePads.pads()) {
            pads.push_back(pad.position);
        }
        if (std::optional<BoardOutline> outline = findOutline(m_files, m_board, {pads, m_copperBox}, diagnostics())) {
            m_step.profile = std::move(outline->shape);
            m_step.profileFile = std::move(outline->path);
        }
    }

    /// Spans count copper layers from the top; without one a drill passes all of them.
    void setSpans() {
        const auto count = static_cast<int>(m_layers.copper.size());
        for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
            if (m_layers.files[layer] == kNoRow) {
                continue;
            }
            const ReadFile& file = m_files[static_cast<std::size_t>(m_layers.files[layer])];
            const auto [top, bottom] = spanOf(file);
            if (top < 1) {
                continue;
            }
            if (bottom > count) {
                diagnostics().report(Severity::Warning, file.path, 0,
                                     "the drills pass more copper layers than the board has; taken as all of them");
                continue;
            }
            m_layers.layers[layer].spanTop = m_layers.copper[static_cast<std::size_t>(top - 1)];
            m_layers.layers[layer].spanBottom = m_layers.copper[static_cast<std::size_t>(bottom - 1)];
        }
    }

    /// Whole files only: what they take the plating from is the span of a layer. Without one that would be all copper.
    void setBackDrills() {
        for (const auto& [layer, backDrills] : m_backDrills) {
            formats::DrawnLayer& row = m_layers.layers[layer];
            if (backDrills == BackDrills::None) {
                continue;
            }
            if (backDrills == BackDrills::Some || row.spanTop < 0) {
                diagnostics().report(Severity::Warning, row.file, 0,
                                     backDrills == BackDrills::Some
                                         ? "some holes of the file are back-drills and others are not; they are shown "
                                           "as NPTH and take no plating"
                                         : "the file of back-drills does not say which layers they pass; they are "
                                           "shown as NPTH and take no plating");
                continue;
            }
            row.use = LayerUse::Backdrill;
        }
    }

    struct Span {
        int top = 0;  ///< 0: not said
        int bottom = 0;
    };

    [[nodiscard]] Span spanOf(const ReadFile& file) {
        const FileRole& role = file.role;
        if (role.spanTop > 0 || role.spanBottom > 0) {
            return {std::min(role.spanTop, role.spanBottom), std::max(role.spanTop, role.spanBottom)};
        }
        const LayerPair* const pair = pairOf(file);
        return pair == nullptr ? spanOfName(file) : spanOf(*pair, file.path);
    }

    /// Numbers in names are those of copper layers if one of the board's drill files passes all of them by its name.
    [[nodiscard]] Span spanOfName(const ReadFile& file) {
        const Span all{1, static_cast<int>(m_layers.copper.size())};
        const bool areLayers = std::ranges::any_of(m_board.files, [&](std::size_t row) {
            const std::optional<Span> span = isOfHoles(m_files[row]) ? namedSpan(m_files[row].name()) : std::nullopt;
            return span && span->top == all.top && span->bottom == all.bottom;
        });
        const std::optional<Span> span = areLayers ? namedSpan(file.name()) : std::nullopt;
        if (span && (span->top > all.top || span->bottom < all.bottom)) {
            diagnostics().report(Severity::Info, file.path, 0,
                                 "only the name of the drill file says which copper layers its holes pass; taken as " +
                                     std::to_string(span->top) + " to " + std::to_string(span->bottom));
        }
        return span.value_or(Span{});
    }

    /// Counted from the top.
    [[nodiscard]] std::optional<Span> namedSpan(std::string_view name) const {
        const std::optional<NamedSpan> span = spanInName(name);
        if (!span) {
            return std::nullopt;
        }
        if (!span->isOfEagle) {
            return Span{span->first, span->last};
        }
        const int first = copperOfEagle(span->first);
        const int last = copperOfEagle(span->last);
        return first > 0 && first < last ? std::optional(Span{first, last}) : std::nullopt;
    }

    /// Counted from the top, of Eagle's number of a layer; 0 if there is none.
    [[nodiscard]] int copperOfEagle(int number) const {
        constexpr int kBottom = 16;
        const auto count = static_cast<int>(m_layers.copper.size());
        for (int i = 1; i < count - 1 && number > 1 && number < kBottom; ++i) {
            const std::int32_t row =
                m_layers.files[static_cast<std::size_t>(m_layers.copper[static_cast<std::size_t>(i)])];
            if (m_files[static_cast<std::size_t>(row)].role.order == number) {
                return i + 1;
            }
        }
        return number == 1 ? 1 : number == kBottom ? count : 0;
    }

    Span spanOf(const LayerPair& pair, const std::string& path) {
        const bool isNamed =
            std::ranges::any_of(pair.endings, [&](const std::string& ending) { return copperWithEnding(ending) > 0; });
        const int first = isNamed ? copperWithEnding(pair.endings.front()) : copperOfAltium(pair.endings.front());
        const int last = isNamed ? copperWithEnding(pair.endings.back()) : copperOfAltium(pair.endings.back());
        if (first < 1 || last < 1) {
            diagnostics().report(Severity::Warning, path, 0,
                                 "the drills begin or end on a layer of which the job has no image; taken through all");
            return {};
        }
        return {std::min(first, last), std::max(first, last)};
    }

    /// Counted from the top, of the ending that Altium gives by itself, which it writes also where all files end in
    /// ".gbr": GTL, G1, G2, GBL. 0 if there is no such layer, or if nothing tells which: signals and planes (GP1) are
    /// counted each by themselves, and the names of the images no longer say how they alternate.
    [[nodiscard]] int copperOfAltium(const std::string& ending) const {
        const std::optional<FileRole> role = roleOfName("x." + ending);
        if (!role || role->kind != FileRole::Kind::Copper) {
            return 0;
        }
        const int count = static_cast<int>(m_layers.copper.size());
        const bool isOfOneKind =
            (role->isNegative || !arePlanesNamed()) &&
            std::all_of(m_layers.copper.begin() + 1, m_layers.copper.begin() + std::max(1, count - 1),
                        [&](std::int32_t row) {
                            return m_layers.layers[static_cast<std::size_t>(row)].isNegative == role->isNegative;
                        });
        const int inner = isOfOneKind && role->order > 0 && role->order < count - 1 ? role->order + 1 : 0;
        return role->side == LayerSide::Top ? 1 : role->side == LayerSide::Bottom ? count : inner;
    }

    /// By a layer pair of the job.
    [[nodiscard]] bool arePlanesNamed() const {
        return std::ranges::any_of(m_files, [](const ReadFile& file) {
            return std::ranges::any_of(file.layerPairs, &LayerPair::namesPlanes);
        });
    }

    /// Counted from the top; 0 if no copper layer's file is named so.
    [[nodiscard]] int copperWithEnding(const std::string& ending) const {
        for (std::size_t i = 0; i < m_layers.copper.size(); ++i) {
            const std::int32_t row = m_layers.files[static_cast<std::size_t>(m_layers.copper[i])];
            const std::string_view name = m_files[static_cast<std::size_t>(row)].name();
            if (equalsIgnoringCase(name.substr(name.find_last_of('.') + 1), ending)) {
                return static_cast<int>(i) + 1;
            }
        }
        return 0;
    }

    /// None if no netlist says how thick the board is.
    std::optional<double> thicknessOfNetlists() {
        for (const std::size_t row : m_board.files) {
            const D356& netlist = m_files[row].netlist;
            if (netlist.boardNm) {
                diagnostics().report(Severity::Info, m_files[row].path, netlist.boardLine,
                                     "the thickness of the board is that of the netlist's comments");
                return netlist.boardNm;
            }
        }
        return std::nullopt;
    }

    void finish() {
        m_step.componentsFile = m_step.componentsFile.empty() && !m_layers.copper.empty()
                                    ? m_layers.layers[static_cast<std::size_t>(m_layers.copper[0])].file
                                    : m_step.componentsFile;
        m_parts.finish(diagnostics());
        formats::DrawnJob& job = m_result.job;
        m_step.name = m_board.name.empty() ? "board" : m_board.name;
        job.layers = std::move(m_layers.layers);
        job.boardNm = m_job.boardNm ? m_job.boardNm : thicknessOfNetlists();
        job.info.name = !m_job.name.empty() ? m_job.name : m_jobName;
        job.info.generator = m_job.generator;
        job.info.version = "Gerber";
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            const bool saysMore = job.info.generator.empty() && file.isImage();
            if (saysMore) {
                job.info.generator = std::string(file.image.fileAttribute(".GenerationSoftware"));
                std::ranges::replace(job.info.generator, ',', ' ');
            }
        }
        Diagnostics all;
        for (const std::size_t row : m_board.files) {
            all.append(m_files[row].image.diagnostics);
            all.append(m_files[row].diagnostics);
        }
        all.append(job.diagnostics);
        job.diagnostics = std::move(all);
        job.info.units = isMostInInches() ? "INCH" : "MM";
        job.steps.push_back(std::move(m_step));
    }

    /// Drawings only: programs write drills in a unit of their own.
    [[nodiscard]] bool isMostInInches() const {
        int more = 0;
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            const bool isDrawing = file.kind == ReadFile::Kind::Gerber && !file.isIgnored();
            more += !isDrawing ? 0 : file.image.isInInches ? 1 : -1;
        }
        return more > 0;
    }

    std::vector<ReadFile>& m_files;
    const BoardFiles& m_board;
    const std::string& m_jobName;
    MadeBoard m_result;
    formats::DrawnStep m_step;
    JobFileFacts m_job;
    OrderedLayers m_layers;
    std::vector<std::pair<std::size_t, BackDrills>> m_backDrills;  ///< by layer of holes
    Box m_copperBox;
    PadIndex m_filePads;  ///< before layers are ordered
    NetNames m_nets;
    PartList m_parts;
};

}  // namespace

MadeBoard makeBoard(std::vector<ReadFile>& files, const BoardFiles& board, const std::string& jobName) {
    return BoardMaker(files, board, jobName).run();
}

}  // namespace model::gerber
