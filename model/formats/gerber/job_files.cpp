#include "model/formats/gerber/job_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "model/base/ascii.h"
#include "model/base/median.h"
#include "model/base/parallel.h"
#include "model/formats/gerber/text/words.h"
#include "model/text/whole_file.h"

namespace model::gerber {

namespace {

constexpr std::size_t kHead = 100'000;

/// Files that are never read, whatever they hold.
constexpr std::array<std::string_view, 27> kForeign = {
    "PNG",    "JPG",  "JPEG",      "GIF",       "PDF", "ZIP",  "GZ",  "TGZ",       "7Z",
    "RAR",    "STEP", "STP",       "WRL",       "SVG", "HTML", "DXF", "DWG",       "XLSX",
    "PCBDOC", "BRD",  "KICAD_PCB", "KICAD_PRL", "MD",  "DOCX", "GLB", "KICAD_SCH", "PY"};

/// Endings of images and drills beside those that tell what is drawn.
constexpr std::array<std::string_view, 11> kPlainEndings = {"GBR", "GER", "ART",    "PHO", "GDO", "GBRJOB",
                                                            "GB",  "GBX", "GERBER", "FPH", "GRB"};

bool isText(std::string_view text) {
    return text.substr(0, 1000).find('\0') == std::string_view::npos;
}

std::string endingOf(std::string_view name) {
    const std::size_t point = name.rfind('.');
    return point == std::string_view::npos ? std::string() : upperCase(name.substr(point + 1));
}

bool hasGerberOperation(std::string_view head) {
    for (const std::string_view word : {"D01*", "D02*", "D03*", "D1*", "D2*", "D3*"}) {
        if (head.find(word) != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

/// Lines as drill files have them: tools and coordinates, nothing else. Allegro may list the tools in comments only.
bool looksLikeDrills(std::string_view head) {
    Lines lines(head);
    int hits = 0;
    int tools = 0;
    int others = 0;
    while (lines.next() && hits + others < 200) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty() || line[0] == ';' || line == "%") {
            tools += holds(line, "Holesize") ? 1 : 0;
            continue;
        }
        const bool isCode = line.size() > 1 && base::isDigit(line[1]) && line.find(' ') == std::string_view::npos;
        tools += isCode && line[0] == 'T' ? 1 : 0;
        const bool isHit = line.find_first_not_of("XYIJAGRM0123456789+-.") == std::string_view::npos;
        hits += isHit ? 1 : 0;
        others += isHit || (isCode && std::string_view("TMGF").find(line[0]) != std::string_view::npos) ? 0 : 1;
    }
    return tools > 0 && hits > 0 && others * 4 <= hits + tools;
}

bool isDrillText(std::string_view head) {
    Lines lines(head);
    for (int i = 0; i < 40 && lines.next(); ++i) {
        if (trimmed(lines.line()).starts_with("M48")) {
            return true;
        }
    }
    return looksLikeDrills(head);
}

/// Coordinates with operations, and tools that nothing defines.
bool isOldGerber(std::string_view text) {
    if (!isText(text) || text.find('%') != std::string_view::npos) {
        return false;
    }
    Lines lines(text.substr(0, kHead));
    int hits = 0;
    int others = 0;
    while (lines.next() && hits + others < 200) {
        const std::string_view line = trimmed(lines.line());
        const bool isHit =
            line.ends_with('*') && line.find_first_not_of("XYIJDGMN0123456789+-*") == std::string_view::npos;
        hits += isHit && line.find_first_of("XY") != std::string_view::npos ? 1 : 0;
        others += isHit || line.empty() || line.starts_with("G04") ? 0 : 1;
    }
    return hits > 10 && others * 10 <= hits && hasGerberOperation(text.substr(0, kHead));
}

void parse(ReadFile& file) {
    const std::string_view text = file.bytes.view();
    switch (file.kind) {
        case ReadFile::Kind::Gerber: file.image = parseImage(text, file.path); break;
        case ReadFile::Kind::Drills:
            file.head = readDrillHead(text);
            file.format = likelyFormats(file.head).front();
            file.image = parseDrills(text, file.path, file.format);
            break;
        case ReadFile::Kind::Netlist: file.netlist = parseD356(text, file.path, file.diagnostics); break;
        case ReadFile::Kind::Job: file.job = parseJobFile(text, file.path, file.diagnostics); break;
        case ReadFile::Kind::Placements: file.placements = parsePlacements(text, file.path, file.diagnostics); break;
        case ReadFile::Kind::LayerPairs: file.layerPairs = parseLayerPairs(text); break;
        case ReadFile::Kind::Other:
            if (isOldGerber(text)) {
                file.diagnostics.report(Severity::Error, file.path, 0,
                                        "the image is of the old form of Gerber (RS-274-D), whose format and apertures "
                                        "are in another file; it was not read");
                break;
            }
            file.diagnostics.report(Severity::Info, file.path, 0,
                                    "the file is no part of a Gerber job; it was not read");
    }
}

/// Of which file "top.art,1" is an older version, as Allegro keeps them beside it; empty if it is none.
std::string newerVersion(std::string_view path) {
    const std::size_t comma = path.rfind(',');
    const std::string_view number = comma == std::string_view::npos ? "" : path.substr(comma + 1);
    const bool isVersion = !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
    return isVersion ? std::string(path.substr(0, comma)) : std::string();
}

std::optional<FileRole> roleOfJob(const ReadFile& file, const JobFileFacts& job) {
    const auto found = job.functions.find(base::lowerCase(file.name()));
    std::optional<FileRole> role = found == job.functions.end() ? std::nullopt : roleOfFunction(found->second);
    if (role) {
        role->source = RoleSource::JobFile;
        const auto polarity = job.polarities.find(base::lowerCase(file.name()));
        role->isNegative = polarity != job.polarities.end() && equalsIgnoringCase(polarity->second, "Negative");
    }
    return role;
}

/// What is missing in `role` from another source about the same kind of layer.
void complete(FileRole& role, const std::optional<FileRole>& other) {
    if (!other || other->kind != role.kind) {
        return;
    }
    role.side = role.side == LayerSide::None ? other->side : role.side;
    role.plating = role.plating == Plating::NotSaid ? other->plating : role.plating;
    role.isNegative = role.isNegative || other->isNegative;
    if (role.order == 0) {
        role.order = other->order;
        role.isCountedFromTop = other->isCountedFromTop;
    }
}

/// How many characters the names of all images begin with, up to their last joint: the name of the board, whose words
/// tell no layer. 0 where there are too few images to tell.
std::size_t sharedBeginning(const std::vector<ReadFile>& files) {
    std::optional<std::string> shared;
    std::size_t images = 0;
    for (const ReadFile& file : files) {
        if (file.kind != ReadFile::Kind::Gerber) {
            continue;
        }
        const std::string name = upperCase(file.name());
        shared = shared.value_or(name);
        const auto end = std::ranges::mismatch(*shared, name).in1;
        shared->erase(end, shared->end());
        ++images;
    }
    constexpr std::size_t kFewImages = 2;
    const std::size_t joint = images > kFewImages ? shared->find_last_of("._- ") : std::string::npos;
    return joint == std::string::npos ? 0 : joint;
}

/// From a name whose first characters all images of the job share. What only they tell is told of no file: the images
/// of "power-art" are not all power planes.
std::optional<FileRole> roleAmongNames(std::string_view name, std::size_t shared) {
    const std::optional<FileRole> whole = roleOfName(name);
    if (shared == 0 || name.size() <= shared) {
        return whole;
    }
    if (std::optional<FileRole> rest = roleOfName(name.substr(shared))) {
        complete(*rest, whole);
        return rest;
    }
    const std::optional<FileRole> ofShared = roleOfName(std::string(name.substr(0, shared)) + ".x");
    const bool isOfAll = whole && whole->kind == FileRole::Kind::Copper && whole->order == 0 && ofShared &&
                         ofShared->kind == FileRole::Kind::Copper;
    return isOfAll ? std::nullopt : whole;
}

/// Does an image draw the edge of the board only, as the functions of its apertures say? Proteus calls it drills
/// without plating.
bool isProfile(const Image& image) {
    const auto isOfProfile = [&](const formats::DrawnFeature& feature) {
        if (feature.attributes < 0) {
            return false;
        }
        const formats::Words& words = image.attributes[static_cast<std::size_t>(feature.attributes)];
        return std::ranges::any_of(words, [](const auto& word) {
            return word.first == ".AperFunction" && word.second.starts_with("Profile");
        });
    };
    return !image.features.empty() && std::ranges::all_of(image.features, isOfProfile);
}

/// An image that ends as Altium's drills do and has nothing but flashes: CAM programs write their drills so.
bool isImageOfHoles(const ReadFile& file) {
    return file.kind == ReadFile::Kind::Gerber && endingOf(file.name()) == "TXT" && file.image.flashes > 0 &&
           file.image.flashes == file.image.features.size();
}

FileRole roleOf(const ReadFile& file, const JobFileFacts& job, std::size_t shared) {
    std::optional<FileRole> ofAttribute = roleOfFunction(file.image.fileAttribute(".FileFunction"));
    if (ofAttribute && ofAttribute->kind == FileRole::Kind::Drill && isProfile(file.image)) {
        ofAttribute = FileRole{FileRole::Kind::Profile};
        ofAttribute->source = RoleSource::Attribute;
    }
    const std::optional<FileRole> ofJob = roleOfJob(file, job);
    const std::optional<FileRole> ofComments = roleOfComments(file.image);
    std::optional<FileRole> ofName = roleAmongNames(file.name(), file.kind == ReadFile::Kind::Gerber ? shared : 0);
    if (ofName && (ofName->kind == FileRole::Kind::Drill) && file.kind == ReadFile::Kind::Gerber &&
        file.image.flashes == 0) {
        ofName.reset();  // a drawing of holes, not the holes
    }
    FileRole role;
    for (const std::optional<FileRole>& one : {ofAttribute, ofJob, ofComments, ofName}) {
        if (!role.isKnown() && one) {
            role = *one;
        } else {
            complete(role, one);
        }
    }
    if (file.kind == ReadFile::Kind::Drills && role.kind != FileRole::Kind::Drill &&
        role.kind != FileRole::Kind::Rout) {
        role = FileRole{FileRole::Kind::Drill};
        role.side = LayerSide::Through;
        role.source = RoleSource::Content;
    }
    if (!role.isKnown() && isImageOfHoles(file)) {
        role = FileRole{FileRole::Kind::Drill};
        role.side = LayerSide::Through;
        role.source = RoleSource::Content;
    }
    const std::string_view polarity = file.image.fileAttribute(".FilePolarity");
    const bool isNegative = equalsIgnoringCase(polarity, "Negative");
    const bool isPositive = equalsIgnoringCase(polarity, "Positive");
    role.isNegative = role.kind == FileRole::Kind::Copper && !isPositive && (role.isNegative || isNegative);
    if (role.kind == FileRole::Kind::Copper && role.side == LayerSide::None) {
        role.side = LayerSide::Inner;
    }
    return role;
}

/// gEDA called masks of the component side so, and that of the solder side just a solder mask: where one of two is on
/// the top and the other tells no side, it is on the bottom.
void takeOtherSide(std::vector<ReadFile>& files, FileRole::Kind kind) {
    std::size_t onTop = 0;
    std::size_t count = 0;
    ReadFile* other = nullptr;
    for (ReadFile& file : files) {
        if (file.isImage() && file.role.kind == kind) {
            ++count;
            onTop += file.role.side == LayerSide::Top ? 1 : 0;
            other = file.role.side == LayerSide::None ? &file : other;
        }
    }
    if (count == 2 && onTop == 1 && other != nullptr) {
        other->role.side = LayerSide::Bottom;
    }
}

/// Is a file, by its name, one of the board that another one belongs to?
bool isOfSameBoard(const ReadFile& file, const ReadFile& other) {
    return file.folder() == other.folder() && upperCase(file.name()).starts_with(boardOfName(other.name()));
}

/// Endings count inner layers alone ("G2" is the third copper layer), attributes count all: where some files have
/// attributes and others none, all count from the top.
void countFromTop(std::vector<ReadFile>& files) {
    const auto isInner = [](const ReadFile& file, bool isCounted) {
        const FileRole& role = file.role;
        return file.isImage() && role.kind == FileRole::Kind::Copper && role.side == LayerSide::Inner &&
               role.order > 0 && role.isCountedFromTop == isCounted;
    };
    const bool isAnyCounted = std::ranges::any_of(
        files, [&](const ReadFile& file) { return isInner(file, true) && file.role.source == RoleSource::Attribute; });
    for (ReadFile& file : files) {
        if (isAnyCounted && isInner(file, false)) {
            ++file.role.order;
            file.role.isCountedFromTop = true;
        }
    }
}

/// Does a file that is copper for sure leave no room for one that only a side in its name calls so? Where the top is
/// number 1, the bottom has a number, too.
bool takesPlaceOf(const ReadFile& other, LayerSide side) {
    const FileRole& role = other.role;
    const bool isOuter = role.side == LayerSide::Top || role.side == LayerSide::Bottom;
    return !role.isSideOnly && (role.side == side || (isOuter && role.isCountedFromTop));
}

/// "board_place_top" and "board_notes_top" are no copper where "board_copper_top" or "board.gtl" is beside them.
void takeSidesForDrawings(std::vector<ReadFile>& files) {
    const auto isCopper = [](const ReadFile& file) {
        return file.isImage() && file.role.kind == FileRole::Kind::Copper;
    };
    for (ReadFile& file : files) {
        const bool isNamed = isCopper(file) && file.role.isSideOnly && file.role.source == RoleSource::Name;
        const bool isDrawing =
            isNamed && std::ranges::any_of(files, [&](const ReadFile& other) {
                return isCopper(other) && takesPlaceOf(other, file.role.side) && isOfSameBoard(file, other);
            });
        if (isDrawing) {
            const LayerSide side = file.role.side;
            file.role = FileRole{FileRole::Kind::Document};
            file.role.side = side;
            file.role.source = RoleSource::Name;
        }
    }
}

}  // namespace

bool isNamedLikeGerber(std::string_view name) {
    const std::string ending = endingOf(name.substr(name.find_last_of('/') + 1));
    const std::optional<FileRole> role = roleOfName("." + ending);
    const bool isDigits = ending.find_first_not_of("0123456789") == std::string::npos;
    return std::ranges::find(kPlainEndings, ending) != kPlainEndings.end() || (role && !isDigits);
}

bool isForeign(std::string_view name) {
    return std::ranges::find(kForeign, endingOf(name)) != kForeign.end();
}

ReadFile::Kind kindOf(std::string_view text, std::string_view name) {
    using Kind = ReadFile::Kind;
    const std::string_view head = text.substr(0, kHead);
    if (!isText(head) || head.starts_with('<') || isForeign(name)) {
        return Kind::Other;
    }
    if (looksLikeJobFile(head)) {
        return Kind::Job;
    }
    if (looksLikeD356(head)) {
        return Kind::Netlist;
    }
    if (looksLikeLayerPairs(head)) {
        return Kind::LayerPairs;
    }
    const bool hasFormat = head.find("%FS") != std::string_view::npos || head.find("%MO") != std::string_view::npos;
    const bool hasAperture = head.find("%AD") != std::string_view::npos || head.find("%AM") != std::string_view::npos;
    if (hasFormat && (hasGerberOperation(head) || head.find("M02") != std::string_view::npos || head.size() == kHead ||
                      hasAperture)) {
        return Kind::Gerber;
    }
    if (isDrillText(head)) {
        return Kind::Drills;
    }
    if (hasGerberOperation(head) &&
        (head.find("%AD") != std::string_view::npos || head.find("G04") != std::string_view::npos)) {
        return Kind::Gerber;
    }
    return looksLikePlacements(head) || looksLikeMounts(head, name) ? Kind::Placements : Kind::Other;
}

ReadFile readFile(std::string path, formats::Bytes bytes) {
    ReadFile file;
    file.path = std::move(path);
    file.bytes = std::move(bytes);
    file.kind = kindOf(file.bytes.view(), file.name());
    parse(file);
    return file;
}

base::Result<std::vector<ReadFile>> readFiles(const formats::Archive& archive, base::Progress& progress) {
    std::vector<int> rows;
    for (const auto& [path, row] : archive.rows()) {
        const std::string_view name = std::string_view(path).substr(path.find_last_of('/') + 1);
        if (!name.starts_with('.') && !isForeign(name)) {
            rows.push_back(row);
        }
    }
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return archive.storedSize(rows[a]) > archive.storedSize(rows[b]); });
    std::vector<ReadFile> files(rows.size());
    base::parallelFor(order.size(), [&](std::size_t i) {
        if (progress.isCancelled()) {
            return;
        }
        const int row = rows[order[i]];
        const std::string newer = base::lowerCase(newerVersion(archive.path(row)));
        if (archive.rows().contains(newer)) {
            files[order[i]].path = archive.path(row);
            files[order[i]].diagnostics.report(
                Severity::Info, archive.path(row), 0,
                "an older version of " + newerVersion(archive.path(row)) + ", which lies beside it; it was not read");
            return;
        }
        base::Result<formats::Bytes> bytes = archive.bytes(row);
        if (bytes) {
            files[order[i]] = readFile(archive.path(row), std::move(*bytes));
        } else {
            files[order[i]].path = archive.path(row);
            files[order[i]].diagnostics.report(Severity::Error, archive.path(row), 0, bytes.error().text);
        }
    });
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return files;
}

base::Result<std::vector<ReadFile>> readFilesAt(const std::filesystem::path& path, base::Progress& progress) {
    std::error_code error;
    std::filesystem::path folder = path;
    if (std::filesystem::is_regular_file(path, error)) {
        ASSIGN_OR_RETURN(std::string text, readWholeFile(path));
        const ReadFile::Kind kind = kindOf(text, path.filename().string());
        if (kind == ReadFile::Kind::Gerber || kind == ReadFile::Kind::Drills) {
            std::vector<ReadFile> files;
            files.push_back(readFile(path.filename().string(), formats::Bytes(std::move(text))));
            return files;
        }
        folder = kind != ReadFile::Kind::Job ? path : path.has_parent_path() ? path.parent_path() : ".";
    }
    Diagnostics unpacking;
    ASSIGN_OR_RETURN(const formats::Archive archive, formats::Archive::open(folder, {}, progress, unpacking));
    return readFiles(archive, progress);
}

void moveFarJob(std::vector<ReadFile>& files) {
    std::size_t there = 0;
    std::size_t beyond = 0;
    std::vector<double> xs;
    std::vector<double> ys;
    for (const ReadFile& file : files) {
        if (file.kind == ReadFile::Kind::Gerber) {
            there += file.image.features.size();
            beyond += file.image.placesBeyond;
        }
        if (file.kind == ReadFile::Kind::Gerber && file.image.placesBeyond > 0) {
            xs.push_back(file.image.cornerBeyond.x);
            ys.push_back(file.image.cornerBeyond.y);
        }
    }
    if (beyond <= there) {
        return;
    }
    // Frames of drawings may be far from the board: most images are none.
    constexpr double kStep = 1e8;  ///< nm: a round number, which people can add in their heads
    const base::PointD shift{0.0 - std::floor(base::medianOf(xs) / kStep) * kStep,
                             0.0 - std::floor(base::medianOf(ys) / kStep) * kStep};
    base::parallelFor(files.size(), [&](std::size_t i) {
        ReadFile& file = files[i];
        if (file.kind == ReadFile::Kind::Gerber) {
            file.image = parseImage(file.bytes.view(), file.path, shift);
        } else if (file.kind == ReadFile::Kind::Drills) {
            file.format.shift = shift;
            file.image = parseDrills(file.bytes.view(), file.path, file.format);
        }
    });
    const auto first = std::ranges::find(files, ReadFile::Kind::Gerber, &ReadFile::kind);
    first->diagnostics.report(Severity::Warning, first->path, 0,
                              "the job lies farther out than coordinates reach (1.07 m); all of it was moved by " +
                                  shortNumber(shift.x / 1e6) + ", " + shortNumber(shift.y / 1e6) + " mm");
}

void assignRoles(std::vector<ReadFile>& files, const JobFileFacts& job) {
    const std::size_t shared = sharedBeginning(files);
    for (ReadFile& file : files) {
        if (file.isImage()) {
            file.role = roleOf(file, job, shared);
        }
    }
    for (const FileRole::Kind kind : {FileRole::Kind::SolderMask, FileRole::Kind::Legend, FileRole::Kind::Paste}) {
        takeOtherSide(files, kind);
    }
    takeSidesForDrawings(files);
    countFromTop(files);
}

}  // namespace model::gerber
