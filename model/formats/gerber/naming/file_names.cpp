#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "model/base/ascii.h"
#include "model/formats/gerber/naming/file_role.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

/// An ending that says all.
struct Ending {
    std::string_view ending;
    Kind kind;
    LayerSide side = LayerSide::None;
    Plating plating = Plating::NotSaid;
};

constexpr LayerSide kTop = LayerSide::Top;
constexpr LayerSide kBottom = LayerSide::Bottom;
constexpr LayerSide kThrough = LayerSide::Through;

/// Protel and Altium, also used by KiCad, EasyEDA and OSH Park; Eagle; Target 3001!; pcb-rnd's assembly drawings;
/// Xpedition's drills.
constexpr std::array kEndings = {
    Ending{"GTL", Kind::Copper, kTop},     Ending{"GBL", Kind::Copper, kBottom},
    Ending{"GTS", Kind::SolderMask, kTop}, Ending{"GBS", Kind::SolderMask, kBottom},
    Ending{"GTO", Kind::Legend, kTop},     Ending{"GBO", Kind::Legend, kBottom},
    Ending{"GTP", Kind::Paste, kTop},      Ending{"GBP", Kind::Paste, kBottom},
    Ending{"GKO", Kind::Profile},          Ending{"GML", Kind::Profile},
    Ending{"OLN", Kind::Profile},          Ending{"GPT", Kind::Document},
    Ending{"GPB", Kind::Document},         Ending{"GDD", Kind::Document},
    Ending{"GDG", Kind::Document},         Ending{"GD1", Kind::Document},
    Ending{"CMP", Kind::Copper, kTop},     Ending{"SOL", Kind::Copper, kBottom},
    Ending{"STC", Kind::SolderMask, kTop}, Ending{"STS", Kind::SolderMask, kBottom},
    Ending{"PLC", Kind::Legend, kTop},     Ending{"PLS", Kind::Legend, kBottom},
    Ending{"CRC", Kind::Paste, kTop},      Ending{"CRS", Kind::Paste, kBottom},
    Ending{"BOR", Kind::Profile},          Ending{"DRL", Kind::Drill, kThrough},
    Ending{"XLN", Kind::Drill, kThrough},  Ending{"DRD", Kind::Drill, kThrough},
    Ending{"NCD", Kind::Drill, kThrough},  Ending{"EXC", Kind::Drill, kThrough},
    Ending{"XNC", Kind::Drill, kThrough},  Ending{"CNC", Kind::Drill, kThrough},
    Ending{"ROU", Kind::Rout, kThrough},   Ending{"TAP", Kind::Drill, kThrough},
    Ending{"TOP", Kind::Copper, kTop},     Ending{"BOT", Kind::Copper, kBottom},
    Ending{"SMT", Kind::SolderMask, kTop}, Ending{"SMB", Kind::SolderMask, kBottom},
    Ending{"SST", Kind::Legend, kTop},     Ending{"SSB", Kind::Legend, kBottom},
    Ending{"SPT", Kind::Paste, kTop},      Ending{"SPB", Kind::Paste, kBottom},
    Ending{"POSITOP", Kind::Legend, kTop}, Ending{"POSIBOT", Kind::Legend, kBottom},
    Ending{"AST", Kind::Document},         Ending{"ASB", Kind::Document},
    Ending{"GM", Kind::Profile},           Ending{"MIL", Kind::Profile},
};

/// Words of names: all of them have to be there, none of the others. Upper case; the first row that fits counts, so
/// what is narrower comes first.
struct Words {
    std::array<std::string_view, 2> all;  ///< one, or two
    Kind kind;
    LayerSide side = LayerSide::None;
    Plating plating = Plating::NotSaid;
};

constexpr Words kWords[] = {
    {{"EDGE_CUT"}, Kind::Profile},
    {{"EDGE.CUT"}, Kind::Profile},
    {{"EDGECUT"}, Kind::Profile},
    {{"BOARDOUT"}, Kind::Profile},
    {{"OUTLINE"}, Kind::Profile},
    {{"OUTLLINE"}, Kind::Profile},
    {{"PROFILE"}, Kind::Profile},
    {{"TOPDIMENSION"}, Kind::Document, kTop},  // DipTrace: lengths with arrows
    {{"BOTTOMDIMENSION"}, Kind::Document, kBottom},
    {{"DIMENSION"}, Kind::Profile},
    {{"PCB_EDGES"}, Kind::Profile},  // KiCad until 2013
    {{"DOCUMENT"}, Kind::Document},  // EasyEDA's layers that are no part of a board
    {{"COMPONENTSHAPE"}, Kind::Document},
    {{"LEADSHAPE"}, Kind::Document},
    {{"COMPONENTMARKING"}, Kind::Document},
    {{"3DMODEL"}, Kind::Document},
    {{"3D", "BODY"}, Kind::Document},  // Altium's mechanical layers
    {{"COMPONENT", "CENTER"}, Kind::Document},
    {{"PLACE", "BOUND"}, Kind::Document},  // Allegro's classes, also in designs that were moved to Altium
    {{"NCLEGEND"}, Kind::Document},
    {{"PLACEMENT"}, Kind::Document},
    {{"DRILL", "DRAW"}, Kind::Document},
    {{"DRILL", "MAP"}, Kind::Document},
    {{"DRILLMAP"}, Kind::Document},
    {{"DRILL", "GUIDE"}, Kind::Document},
    {{"DRL", "MAP"}, Kind::Document},
    {{"FAB"}, Kind::Document},
    {{"ASSY"}, Kind::Document},
    {{"ASSEMBLY"}, Kind::Document},
    {{"ADHES"}, Kind::Glue},
    {{"COURTYARD"}, Kind::Document},
    {{"CRTYD"}, Kind::Document},
    {{"KEEPOUT"}, Kind::Document},
    {{"MARGIN"}, Kind::Document},
    {{"MECHANICAL"}, Kind::Document},
    {{"NPTH"}, Kind::Drill, kThrough, Plating::NonPlated},
    {{"NONPLATED"}, Kind::Drill, kThrough, Plating::NonPlated},
    {{"NON", "PLATED"}, Kind::Drill, kThrough, Plating::NonPlated},
    {{"UNPLATED"}, Kind::Drill, kThrough, Plating::NonPlated},
    {{"CONTOUR", "PLATED"}, Kind::Rout, kThrough, Plating::Plated},
    {{"CONTOUR"}, Kind::Profile},  // Fritzing
    {{"ROUT"}, Kind::Rout, kThrough},
    {{"SLOTHOLE"}, Kind::Rout, kThrough},
    {{"PTH"}, Kind::Drill, kThrough, Plating::Plated},
    {{"PLATED"}, Kind::Drill, kThrough, Plating::Plated},
    {{"DRILL"}, Kind::Drill, kThrough},
    {{"HOLES"}, Kind::Drill, kThrough},
    {{"COMPONENTMASK"}, Kind::SolderMask, kTop},  // gEDA
    {{"COMPONENTSILK"}, Kind::Legend, kTop},
    {{"METALMASK-A"}, Kind::Paste, kTop},  // Zuken: sides A and B
    {{"METALMASK-B"}, Kind::Paste, kBottom},
    {{"RESIST-A"}, Kind::SolderMask, kTop},
    {{"RESIST-B"}, Kind::SolderMask, kBottom},
    {{"SYMBOL-A"}, Kind::Legend, kTop},
    {{"SYMBOL-B"}, Kind::Legend, kBottom},
    {{"SILKSCMP"}, Kind::Legend, kTop},  // KiCad until 2013: component and copper side
    {{"SILKSCOP"}, Kind::Legend, kBottom},
    {{"MASKCMP"}, Kind::SolderMask, kTop},
    {{"MASKCOP"}, Kind::SolderMask, kBottom},
    {{"SOLDPCMP"}, Kind::Paste, kTop},
    {{"SOLDPCOP"}, Kind::Paste, kBottom},
    {{"SOLDP_"}, Kind::Paste},
    {{"PASTE"}, Kind::Paste},
    {{"STENCIL"}, Kind::Paste},
    {{"TCREAM"}, Kind::Paste, kTop},  // Eagle's own name of the layer
    {{"BCREAM"}, Kind::Paste, kBottom},
    {{"SOLDERMASK"}, Kind::SolderMask},
    {{"SOLDER", "MASK"}, Kind::SolderMask},
    {{"STOP"}, Kind::SolderMask},
    {{"RESIST"}, Kind::SolderMask},
    {{"MASK"}, Kind::SolderMask},
    {{"SILK"}, Kind::Legend},
    {{"LEGEND"}, Kind::Legend},
    {{"OVERLAY"}, Kind::Legend},
    {{"NOMENCLATURE"}, Kind::Legend},
    {{"SMT"}, Kind::SolderMask, kTop},
    {{"SMB"}, Kind::SolderMask, kBottom},
    {{"SST"}, Kind::Legend, kTop},
    {{"SSB"}, Kind::Legend, kBottom},
    {{"SMC"}, Kind::SolderMask, kTop},  // component side and solder side
    {{"SMS"}, Kind::SolderMask, kBottom},
    {{"SPC"}, Kind::Paste, kTop},
    {{"SPS"}, Kind::Paste, kBottom},
    {{"TSLK"}, Kind::Legend, kTop},
    {{"BSLK"}, Kind::Legend, kBottom},
    {{"COPPER"}, Kind::Copper},
    {{"CONDUCTIVE"}, Kind::Copper},
    {{"SIGNAL"}, Kind::Copper},
    {{"PLANE"}, Kind::Copper},
    {{"ETCH"}, Kind::Copper},
    {{"_CU"}, Kind::Copper},
    {{".CU"}, Kind::Copper},
    {{"-CU"}, Kind::Copper},
    {{"INNER"}, Kind::Copper},
    {{"LAYER"}, Kind::Copper},
    {{"GROUP"}, Kind::Copper},
    {{"PRIMARY"}, Kind::Copper, kTop},
    {{"SECONDARY"}, Kind::Copper, kBottom},
    {{"TOP"}, Kind::Copper, kTop},
    {{"BOTTOM"}, Kind::Copper, kBottom},
    {{"BOT"}, Kind::Copper, kBottom},
    {{"GND"}, Kind::Copper},
    {{"VCC"}, Kind::Copper},
    {{"PWR"}, Kind::Copper},
    {{"POWER"}, Kind::Copper},
};

/// Names that companies give to films of Allegro, OrCAD and PADS: two letters for what is drawn, and TOP or BOT, or PR
/// or SE for the primary and the secondary side. They count where they stand alone, before the words above: "SSTOP" is
/// no "STOP".
constexpr Words kFilmNames[] = {
    {{"SMTOP"}, Kind::SolderMask, kTop}, {{"SMBOT"}, Kind::SolderMask, kBottom},
    {{"SMPR"}, Kind::SolderMask, kTop},  {{"SMSE"}, Kind::SolderMask, kBottom},
    {{"SSTOP"}, Kind::Legend, kTop},     {{"SSBOT"}, Kind::Legend, kBottom},
    {{"SLTOP"}, Kind::Legend, kTop},     {{"SLBOT"}, Kind::Legend, kBottom},
    {{"SLPR"}, Kind::Legend, kTop},      {{"SLSE"}, Kind::Legend, kBottom},
    {{"SKTOP"}, Kind::Legend, kTop},     {{"SKBOT"}, Kind::Legend, kBottom},
    {{"SLKTOP"}, Kind::Legend, kTop},    {{"SLKBOT"}, Kind::Legend, kBottom},
    {{"SPTOP"}, Kind::Paste, kTop},      {{"SPBOT"}, Kind::Paste, kBottom},
    {{"SPPR"}, Kind::Paste, kTop},       {{"SPSE"}, Kind::Paste, kBottom},
    {{"PMTOP"}, Kind::Paste, kTop},      {{"PMBOT"}, Kind::Paste, kBottom},
    {{"ASTOP"}, Kind::Document, kTop},   {{"ASBOT"}, Kind::Document, kBottom},
    {{"ASSTOP"}, Kind::Document, kTop},  {{"ASSBOT"}, Kind::Document, kBottom},
    {{"ASYTOP"}, Kind::Document, kTop},  {{"ASYBOT"}, Kind::Document, kBottom},
    {{"ASPR"}, Kind::Document, kTop},    {{"ASSE"}, Kind::Document, kBottom},
};

/// Copper that is called by nothing but its side: gEDA's layers, and KiCad's until 2013. These words count only where
/// they stand alone, and where none of the others is there.
struct SideWord {
    std::string_view word;
    LayerSide side;
};

constexpr std::array kSideWords = {SideWord{"FRONT", kTop}, SideWord{"BACK", kBottom}, SideWord{"COMPONENT", kTop}};

/// A word that stands alone: no letter before it, unless it begins with a joint, or behind it.
bool hasAlone(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !base::isLetter(word.front()) || !base::isLetter(text[at - 1]);
        if (begins && (end == text.size() || !base::isLetter(text[end]))) {
            return true;
        }
    }
    return false;
}

/// "ROUT", but not that of "ROUTER", which is what a board may be; nor "CONTOUR" of "CONTOURS", which are not the
/// board's.
bool hasWord(std::string_view text, std::string_view word) {
    const std::string_view other = word == "ROUT" ? "ROUTER" : word == "CONTOUR" ? "CONTOURS" : "";
    std::size_t at = text.find(word);
    while (at != std::string_view::npos && !other.empty() && text.substr(at).starts_with(other)) {
        at = text.find(word, at + 1);
    }
    return at != std::string_view::npos;
}

/// A word that may be part of a longer one, but begins where no letter stands before it: "F_", but not that of "ELF_".
bool hasBeginning(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        if (at == 0 || !base::isLetter(text[at - 1])) {
            return true;
        }
    }
    return false;
}

/// "TOP", but not that of "STOP".
bool hasTop(std::string_view name) {
    for (std::size_t at = name.find("TOP"); at != std::string_view::npos; at = name.find("TOP", at + 1)) {
        if (at == 0 || name[at - 1] != 'S') {
            return true;
        }
    }
    return false;
}

LayerSide sideOfName(std::string_view name) {
    const auto has = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
    if (hasTop(name) || hasBeginning(name, "F_") || hasBeginning(name, "F.") || has("FRONT") ||
        hasAlone(name, "PRIMARY") || hasAlone(name, "PRM") || hasAlone(name, "CS") || hasAlone(name, "COMP")) {
        return kTop;
    }
    if (has("BOT") || hasBeginning(name, "B_") || hasBeginning(name, "B.") || has("BACK") ||
        hasAlone(name, "SECONDARY") || hasAlone(name, "SEC") || hasAlone(name, "PS") || hasAlone(name, "SOLD")) {
        return kBottom;
    }
    return LayerSide::None;
}

/// The number of an inner layer: behind L, LAYER, IN, INNER, G, GROUP or at the end.
int numberIn(std::string_view name) {
    for (std::size_t i = name.size(); i > 0; --i) {
        if (!base::isDigit(name[i - 1])) {
            continue;
        }
        std::size_t begin = i - 1;
        while (begin > 0 && base::isDigit(name[begin - 1])) {
            --begin;
        }
        const int number = parseInteger(name.substr(begin, i - begin)).value_or(0);
        if (number > 0 && number < 100) {
            return number;
        }
        i = begin + 1;
    }
    return 0;
}

/// "L2", "LAYER_3", "L4_SECONDARY", "CONDUCTIVE-1": counts all copper layers from the top.
int layerNumber(std::string_view name) {
    for (const std::string_view word : {"LAYER", "LYR", "L", "CONDUCTIVE"}) {
        for (std::size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
            if (at > 0 && base::isLetter(name[at - 1])) {
                continue;
            }
            std::string_view rest = name.substr(at + word.size());
            rest.remove_prefix(std::min(rest.find_first_not_of("_- ."), rest.size()));
            const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
            const int number = digits > 0 && digits < 3 ? parseInteger(rest.substr(0, digits)).value_or(0) : 0;
            if (number > 0) {
                return number;
            }
        }
    }
    return 0;
}

struct Parts {
    std::string stem;    ///< upper case
    std::string ending;  ///< upper case, without the point
};

Parts partsOf(std::string_view name) {
    const std::string upper = upperCase(name);
    const std::size_t point = upper.rfind('.');
    return point == std::string::npos ? Parts{upper, ""} : Parts{upper.substr(0, point), upper.substr(point + 1)};
}

std::optional<FileRole> roleOfEnding(std::string_view ending) {
    FileRole role;
    role.source = RoleSource::Name;
    const auto row = std::ranges::find(kEndings, ending, &Ending::ending);
    if (row != kEndings.end()) {
        role.kind = row->kind;
        role.side = row->side;
        role.plating = row->plating;
        return role;
    }
    const std::size_t letters = ending.find_first_of("0123456789");
    const std::string_view word = ending.substr(0, letters);
    std::string_view digits = letters == std::string_view::npos ? "" : ending.substr(letters);
    const bool isEagle = word == "G" && digits.ends_with('L');  // "G2L": also OSH Park
    if (isEagle) {
        digits.remove_suffix(1);
    }
    const int number = parseInteger(digits).value_or(0);
    if (number > 0 && (word == "G" || word == "GL" || word == "GP" || word == "GI" || word == "IN" || word == "LY")) {
        role.kind = Kind::Copper;  // Altium: inner layers and internal planes (GP), from 1
        role.side = LayerSide::Inner;
        role.isNegative = word == "GP";  // Protel and Altium draw what is left out of these
        role.order = number;
        role.mayLeaveOutNumbers = isEagle;
        return role;
    }
    if (number > 0 && (word == "GM" || word == "GD" || word == "GG")) {
        role.kind = word == "GM" && number == 1 ? Kind::Profile : Kind::Document;
        return role;
    }
    return std::nullopt;
}

bool isSideWord(std::string_view word) {
    return word == "TOP" || word == "BOTTOM" || word == "BOT" || word == "PRIMARY" || word == "SECONDARY";
}

FileRole namedCopper(LayerSide side) {
    FileRole role;
    role.source = RoleSource::Name;
    role.kind = Kind::Copper;
    role.side = side;
    return role;
}

/// From the words in a stem or an ending; of drills only what holes are.
std::optional<FileRole> roleOfWords(std::string_view text, bool areHoles) {
    const auto film =
        std::ranges::find_if(kFilmNames, [&](const Words& row) { return !areHoles && hasAlone(text, row.all[0]); });
    if (film != std::ranges::end(kFilmNames)) {
        FileRole role;
        role.source = RoleSource::Name;
        role.kind = film->kind;
        role.side = film->side;
        return role;
    }
    for (const Words& row : kWords) {
        const bool fits = std::ranges::all_of(row.all, [&](std::string_view word) {
            return word.empty() || (word.size() > 3 ? hasWord(text, word) : hasAlone(text, word));
        });
        const bool isHole = row.kind == Kind::Drill || row.kind == Kind::Rout;
        if (!fits || (areHoles && !isHole)) {
            continue;
        }
        FileRole role;
        role.source = RoleSource::Name;
        role.kind = row.kind;
        role.plating = row.plating;
        role.side = row.side != LayerSide::None ? row.side : sideOfName(text);
        if (role.kind == Kind::Copper && role.side == LayerSide::None) {
            role.side = LayerSide::Inner;
            role.order = layerNumber(text);
            role.isCountedFromTop = role.order > 0;
            // "GND2" is a name, not a number of a layer.
            const bool isNamed =
                row.all[0] == "GND" || row.all[0] == "VCC" || row.all[0] == "PWR" || row.all[0] == "POWER";
            role.order = role.order > 0 || isNamed ? role.order : numberIn(text);
        }
        role.isSideOnly = isSideWord(row.all[0]);
        if (role.kind == Kind::Copper && role.order == 0) {
            role.order = layerNumber(text);
            role.isCountedFromTop = role.order > 0;
        }
        return role;
    }
    const auto side =
        std::ranges::find_if(kSideWords, [&](const SideWord& row) { return !areHoles && hasAlone(text, row.word); });
    if (side == kSideWords.end()) {
        return std::nullopt;
    }
    FileRole role = namedCopper(side->side);
    role.isSideOnly = true;
    return role;
}

/// PADS numbers its films: "art002.pho", "sm001021.pho", "smd0123.pho" are the layer, and then what is drawn on it. Its
/// planes, "pgp002.pho", draw what is left out.
std::optional<FileRole> roleOfPads(std::string_view stem) {
    const std::size_t letters = std::min(stem.find_first_of("0123456789"), stem.size());
    const std::string_view word = stem.substr(0, letters);
    const std::string_view digits = stem.substr(letters);
    const bool isNumber = digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (!isNumber || digits.size() < 2 || digits.size() > 6) {
        return std::nullopt;
    }
    const int layer = parseInteger(digits.substr(0, digits.size() == 4 ? 2 : 3)).value_or(0);
    const LayerSide outer = layer == 1 ? kTop : kBottom;
    FileRole role = namedCopper(layer == 1 ? kTop : LayerSide::Inner);
    if (word == "ART" || word == "PGP") {
        role.order = layer;
        role.isCountedFromTop = layer > 0;
        role.isNegative = word == "PGP";
    } else if (word == "SM" || word == "SMD") {
        role.kind = word == "SM" ? Kind::SolderMask : Kind::Paste;
        role.side = outer;
    } else if (word == "DD") {
        role.kind = Kind::Document;
        role.side = LayerSide::None;
    } else {
        return std::nullopt;
    }
    return role;
}

/// Words that stand in names of layers without telling one; "IN2" is "IN" with a number, but "B1" a revision.
constexpr std::array<std::string_view, 15> kLayerWords = {
    "F", "B", "CUTS", "EDGE", "CU", "SCREEN", "SOLDER", "NC", "USER", "IN", "GERBER", "BOARD", "DRAWING", "PRM", "SEC"};

bool isRoleWord(std::string_view word) {
    const std::size_t count = word.find_last_not_of("0123456789") + 1;
    const std::string_view letters = count > 1 ? word.substr(0, count) : word;
    return std::ranges::find(kLayerWords, letters) != kLayerWords.end() ||
           roleOfName(std::string(word) + ".X").has_value();
}

}  // namespace

std::optional<FileRole> roleOfName(std::string_view name) {
    const Parts parts = partsOf(name);
    std::optional<FileRole> ofEnding = roleOfEnding(parts.ending);
    const bool isDrill = ofEnding && (ofEnding->kind == Kind::Drill || ofEnding->kind == Kind::Rout);
    if (ofEnding && !isDrill) {
        return ofEnding;
    }
    if (const std::optional<FileRole> ofPads = parts.ending == "PHO" ? roleOfPads(parts.stem) : std::nullopt) {
        return ofPads;
    }
    // Target 3001! has words for endings: "board.StopTop".
    std::optional<FileRole> ofWords = ofEnding ? std::nullopt : roleOfWords(parts.ending, false);
    ofWords = ofWords ? ofWords : roleOfWords(parts.stem, isDrill);
    if (ofWords) {
        return ofWords;
    }
    if (!ofEnding && layerNumber(parts.stem) > 0) {
        FileRole role;
        role.source = RoleSource::Name;
        role.kind = Kind::Copper;
        role.side = LayerSide::Inner;
        role.order = layerNumber(parts.stem);
        role.isCountedFromTop = true;
        return role;
    }
    return ofEnding;
}

int numberInName(std::string_view name) {
    return numberIn(partsOf(name).stem);
}

std::string boardOfName(std::string_view name) {
    const std::size_t point = name.rfind('.');
    std::string stem = upperCase(name.substr(0, point));
    const std::string ending = upperCase(point == std::string_view::npos ? std::string_view() : name.substr(point + 1));
    bool isAnyRole = false;
    while (!stem.empty()) {
        const std::size_t joint = stem.find_last_of("._- ");
        const std::string_view last = std::string_view(stem).substr(joint == std::string::npos ? 0 : joint + 1);
        const std::string_view before = std::string_view(stem).substr(0, joint == std::string::npos ? 0 : joint);
        const bool isNumber = !last.empty() && last.find_first_not_of("0123456789") == std::string_view::npos;
        const bool isCounting =
            isNumber && (before.ends_with("LAYER") || before.ends_with("GROUP") || before.ends_with("INNER"));
        if (!last.empty() && !isCounting && !isRoleWord(last)) {
            break;
        }
        isAnyRole = true;
        stem.resize(before.size());
    }
    return isAnyRole || roleOfEnding(ending) || roleOfWords(ending, false) ? stem : std::string();
}

}  // namespace model::gerber
