#include "model/nets/net_groups.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <unordered_map>

#include "model/base/ascii.h"
#include "model/nets/net_statistics.h"

namespace model {

namespace {

/// Attributes that name the class or pair of a net; a leading dot (attributes of the format itself) and case do not
/// matter.
constexpr std::string_view kClassAttributes[] = {"net_type", "electrical_class", "net_class", "netclass", "class"};
constexpr std::string_view kPairAttributes[] = {"diff_pair", "differential_pair", "diffpair"};

constexpr std::size_t kLeastIndexed = 2;   // members of "A[0]", "A[1]"
constexpr std::size_t kLeastNumbered = 4;  // members of "A0", "A1", …: fewer are no more than alike
/// A bus has at least every so manieth of its numbers; what programs number through has not.
constexpr std::uint64_t kSparsest = 2;
constexpr std::size_t kMostDigits = 6;
constexpr std::uint32_t kRailPins = 4;     // names of several words are rails from so many pins on
constexpr std::uint32_t kManyPins = 16;    // a net with so many pins …
constexpr std::uint64_t kPartOfPins = 10;  // … and this part of all is a supply, whatever its name
constexpr std::size_t kMadeUpDigits = 4;   // "N1234" is no name that people give

constexpr std::string_view kDigits = "0123456789";

bool beginsWith(std::string_view text, std::string_view start) {
    return text.size() >= start.size() && base::equalsIgnoringCase(text.substr(0, start.size()), start);
}

bool endsWith(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && base::equalsIgnoringCase(text.substr(text.size() - end.size()), end);
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(kDigits, at), text.size()) - at;
}

/// The other sign of polarity that a letter or sign may be half of; 0 if none. M is minus only behind D ("DM").
char opposite(char sign, char before) {
    constexpr std::pair<char, char> kSigns[] = {{'P', 'N'}, {'p', 'n'}, {'+', '-'}};
    for (const auto& [positive, negative] : kSigns) {
        if (sign == positive || sign == negative) {
            return sign == positive ? negative : positive;
        }
    }
    return before == 'D' && sign == 'M' ? 'P' : before == 'd' && sign == 'm' ? 'p' : '\0';
}

/// Is the character at `at` a sign of polarity rather than a letter of a word? It ends the name, or has its number
/// behind it, or is a word of its own.
bool isSignAt(std::string_view name, std::size_t at) {
    const std::size_t behind = at + 1;
    if (at == 0 || behind + digitsFrom(name, behind) == name.size()) {
        return at > 0;
    }
    const char before = name[at - 1];
    const bool isOwnWord = !base::isLetter(before) && !base::isDigit(before) && !base::isLetter(name[behind]) &&
                           !base::isDigit(name[behind]);
    return isOwnWord && base::isLetter(name[at]);
}

/// Nets gathered under names, in the order they come.
class Gatherer {
public:
    explicit Gatherer(std::size_t nets) { m_groups.groupOf.assign(nets, kNoGroup); }

    void add(std::size_t net, const std::string& name) {
        const auto [found, isAdded] = m_rows.try_emplace(name, static_cast<std::uint32_t>(m_groups.names.size()));
        if (isAdded) {
            m_groups.names.push_back(name);
        }
        m_groups.groupOf[net] = found->second;
    }
    [[nodiscard]] bool has(std::size_t net) const { return m_groups.groupOf[net] != kNoGroup; }

    /// The groups in the order of their names.
    [[nodiscard]] NetGroups finish() {
        const std::vector<std::uint32_t> ranks = ranksOf(m_groups.names);
        NetGroups sorted{std::vector<std::string>(ranks.size()), std::vector<std::uint32_t>(ranks.size(), 0),
                         std::move(m_groups.groupOf)};
        for (std::size_t row = 0; row < ranks.size(); ++row) {
            sorted.names[ranks[row]] = std::move(m_groups.names[row]);
        }
        for (std::uint32_t& group : sorted.groupOf) {
            group = group == kNoGroup ? kNoGroup : ranks[group];
        }
        return sorted;
    }

private:
    NetGroups m_groups;
    std::unordered_map<std::string, std::uint32_t> m_rows;
};

void gatherByAttribute(const Document& document, std::span<const std::string_view> attributes, Gatherer& out) {
    for (std::size_t net = 0; net < document.nets.size(); ++net) {
        for (const Property& property : document.propertiesOf(document.nets[net].properties)) {
            std::string_view name = document.text(property.name);
            name.remove_prefix(!name.empty() && name.front() == '.' ? 1 : 0);
            const bool isMeant =
                std::ranges::any_of(attributes, [&](auto meant) { return base::equalsIgnoringCase(name, meant); });
            if (isMeant && !document.text(property.value).empty() && !out.has(net)) {
                out.add(net, document.text(property.value));
            }
        }
    }
}

using NetsByName = std::unordered_map<std::string_view, std::size_t>;

/// The net that makes a pair with this one, judged from this one alone; `nets.size()` if none does.
std::size_t twinOf(const Document& document, const NetsByName& byName, std::size_t net) {
    for (const std::string& twin : polarTwins(document.nets[net].name)) {
        if (const auto found = byName.find(twin); found != byName.end()) {
            return found->second;
        }
    }
    return document.nets.size();
}

/// "CLK_P/N0" of "CLK_P0" and "CLK_N0".
std::string pairName(const std::string& a, const std::string& b) {
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    const bool isFirstPositive = base::upperAscii(a[at]) == 'P' || a[at] == '+';
    const std::string& positive = isFirstPositive ? a : b;
    const char negative = isFirstPositive ? b[at] : a[at];
    return positive.substr(0, at + 1) + '/' + negative + positive.substr(at + 1);
}

void gatherPairs(const Document& document, Gatherer& out) {
    NetsByName byName;
    byName.reserve(document.nets.size());
    for (std::size_t net = 0; net < document.nets.size(); ++net) {
        byName.try_emplace(document.nets[net].name, net);
    }
    for (std::size_t net = 0; net < document.nets.size(); ++net) {
        const std::size_t twin = twinOf(document, byName, net);
        const bool isPair = twin > net && twin < document.nets.size() && !out.has(net) && !out.has(twin) &&
                            twinOf(document, byName, twin) == net;
        if (isPair) {
            const std::string name = pairName(document.nets[net].name, document.nets[twin].name);
            out.add(net, name);
            out.add(twin, name);
        }
    }
}

/// Nets alike but for one number.
struct Bus {
    std::vector<std::size_t> nets;
    std::uint32_t lowest = 0xffffffffu;
    std::uint32_t highest = 0;
    bool isIndexed = false;

    [[nodiscard]] bool isBus() const {
        return nets.size() >= (isIndexed ? kLeastIndexed : kLeastNumbered) &&
               std::uint64_t{highest} - lowest + 1 <= kSparsest * nets.size();
    }
};

std::string busName(const std::pair<std::string_view, std::string_view>& parts, const Bus& bus) {
    const std::string numbers = std::to_string(bus.lowest) + ".." + std::to_string(bus.highest);
    return std::string(parts.first) + (bus.isIndexed ? numbers : "[" + numbers + "]") + std::string(parts.second);
}

void gatherBuses(const Document& document, Gatherer& out) {
    std::map<std::pair<std::string_view, std::string_view>, Bus> buses;  // by what is around the number
    for (std::size_t net = 0; net < document.nets.size(); ++net) {
        BusMember member;
        if (supplyOf(document.nets[net].name, 0) != Supply::None || !parseBusMember(document.nets[net].name, member)) {
            continue;
        }
        Bus& bus = buses[{member.before, member.behind}];
        bus.nets.push_back(net);
        bus.lowest = std::min(bus.lowest, member.number);
        bus.highest = std::max(bus.highest, member.number);
        bus.isIndexed = member.isIndexed;
    }
    for (const auto& [parts, bus] : buses) {
        if (bus.isBus()) {
            const std::string name = busName(parts, bus);
            std::ranges::for_each(bus.nets, [&](std::size_t net) { out.add(net, name); });
        }
    }
}

void gatherSupplies(const Document& document, Gatherer& out) {
    const std::vector<std::uint32_t> pins = pinCounts(document);
    for (std::size_t net = 0; net < pins.size(); ++net) {
        const Supply supply = supplyOf(document.nets[net].name, pins[net]);
        if (supply != Supply::None) {
            out.add(net, supply == Supply::Ground ? "Ground" : "Power");
        } else if (pins[net] >= kManyPins && kPartOfPins * pins[net] >= document.pins.size()) {
            out.add(net, "Many pins");
        }
    }
}

/// A sheet by the names of those it lies within and its own; none for the root sheet.
using SheetPath = std::vector<std::string_view>;

SheetPath pathOf(std::string_view sheet) {
    SheetPath path;
    const bool isRooted = sheet.starts_with('/');
    for (std::size_t first = isRooted ? 1 : 0; first < sheet.size();) {
        const std::size_t end = sheet.find(isRooted ? '/' : '\\', first);
        if (end > first) {
            path.push_back(sheet.substr(first, end - first));
        }
        first = end + 1;
    }
    return path;
}

/// Sheets within another follow it.
struct IsSheetBefore {
    bool operator()(const SheetPath& a, const SheetPath& b) const {
        return std::ranges::lexicographical_compare(a, b, isNamedBefore);
    }
};

NetGroups groupBySheet(const Document& document) {
    NetGroups groups;
    groups.backslash = backslashOf(document);
    const auto sheetOfNet = [&](const Net& net) { return sheetOf(net.name, groups.backslash); };
    std::map<SheetPath, std::uint32_t, IsSheetBefore> rows;
    for (const Net& net : document.nets) {
        SheetPath path = pathOf(sheetOfNet(net));
        if (path.empty() && !sheetOfNet(net).empty()) {
            rows.try_emplace(path);
        }
        for (; !path.empty(); path.pop_back()) {
            rows.try_emplace(path);
        }
    }
    for (auto& [path, row] : rows) {
        row = static_cast<std::uint32_t>(groups.names.size());
        groups.names.emplace_back(path.empty() ? "/" : path.back());
        groups.depths.push_back(path.empty() ? 0 : static_cast<std::uint32_t>(path.size() - 1));
    }
    for (const Net& net : document.nets) {
        const std::string_view sheet = sheetOfNet(net);
        groups.groupOf.push_back(sheet.empty() ? kNoGroup : rows.at(pathOf(sheet)));
    }
    return groups;
}

/// Names that a program gave because people had not.
bool isMadeUp(std::string_view name) {
    if (name.empty() || name.front() == '$' || beginsWith(name, "unconnected-")) {
        return true;
    }
    if (name.starts_with("Net") && name.size() > 3 && (name[3] == '-' || (name[3] >= 'A' && name[3] <= 'Z'))) {
        return true;  // "NetC48_2", "Net-(C48-Pad2)"
    }
    return name.front() == 'N' && digitsFrom(name, 1) >= kMadeUpDigits;
}

std::vector<std::string_view> wordsOf(std::string_view name) {
    std::vector<std::string_view> words;
    std::size_t first = 0;
    for (std::size_t at = 0; at <= name.size(); ++at) {
        const bool isPart =
            at < name.size() && (base::isLetter(name[at]) || base::isDigit(name[at]) || name[at] == '.');
        if (!isPart) {
            if (at > first) {
                words.push_back(name.substr(first, at - first));
            }
            first = at + 1;
        }
    }
    return words;
}

/// "5V", "1.8V", "3V3", "12P0V", "5VD".
bool isVoltage(std::string_view word) {
    const std::size_t whole = digitsFrom(word, 0);
    if (whole == 0 || whole == word.size()) {
        return false;
    }
    std::size_t at = whole;
    if (word[at] == '.' || base::upperAscii(word[at]) == 'P') {
        at += 1 + digitsFrom(word, at + 1);
    }
    if (at >= word.size() || base::upperAscii(word[at]) != 'V') {
        return false;
    }
    at += 1 + digitsFrom(word, at + 1);
    return at + 1 >= word.size();  // one letter may follow: analogue, digital
}

/// "VCC", "VDDIO", "V5", "VBAT2".
bool isRail(std::string_view word) {
    constexpr std::string_view kRails[] = {"VCC", "VDD", "VEE", "VBAT", "VBUS", "VIN", "VSYS", "VPP", "VAA", "PWR"};
    const bool isNumbered = word.size() > 1 && base::upperAscii(word[0]) == 'V' && base::isDigit(word[1]);
    return isNumbered || isVoltage(word) ||
           std::ranges::any_of(kRails, [&](std::string_view rail) { return beginsWith(word, rail); });
}

bool isGround(std::string_view word) {
    return beginsWith(word, "GND") || endsWith(word, "GND") || beginsWith(word, "VSS") ||
           base::equalsIgnoringCase(word, "EARTH") || base::equalsIgnoringCase(word, "CHASSIS") ||
           base::equalsIgnoringCase(word, "0V");
}

}  // namespace

std::vector<std::string> polarTwins(std::string_view name) {
    std::vector<std::string> twins;
    const auto add = [&](std::size_t at, char sign) {
        twins.emplace_back(name);
        twins.back()[at] = sign;
    };
    for (std::size_t at = name.size(); at-- > 0;) {
        const char before = at > 0 ? name[at - 1] : '\0';
        const char other = opposite(name[at], before);
        if (other == '\0' || !isSignAt(name, at)) {
            continue;
        }
        add(at, other);
        if (base::upperAscii(before) == 'D' && base::upperAscii(name[at]) == 'P') {
            add(at, static_cast<char>(name[at] - 'P' + 'M'));
        }
    }
    return twins;
}

bool parseBusMember(std::string_view name, BusMember& out) {
    if (isMadeUp(name)) {
        return false;
    }
    const std::size_t end = name.find_last_of(kDigits) + 1;  // 0 if there is none
    const std::size_t first = end == 0 ? 0 : name.find_last_not_of(kDigits, end - 1) + 1;
    if (first == 0 || end - first > kMostDigits) {
        return false;
    }
    out.before = name.substr(0, first);
    out.behind = name.substr(end);
    std::from_chars(name.data() + first, name.data() + end, out.number);
    const std::string around{out.before.back(), out.behind.empty() ? '\0' : out.behind.front()};
    out.isIndexed = around == "[]" || around == "<>";
    return true;
}

Supply supplyOf(std::string_view name, std::uint32_t pins) {
    const std::vector<std::string_view> words = wordsOf(name);
    if (words.empty()) {
        return Supply::None;
    }
    const bool isSure = words.size() == 1 || pins >= kRailPins;
    if (isSure && std::ranges::any_of(words, isGround)) {
        return Supply::Ground;
    }
    return isSure && (isRail(words.front()) || isRail(words.back())) ? Supply::Power : Supply::None;
}

Backslash backslashOf(const Document& document) {
    bool isAnySheet = false;
    bool isAnyBar = document.job.generator.find("Altium") != std::string::npos;
    for (const Net& net : document.nets) {
        if (net.name.ends_with('\\')) {
            return Backslash::Overbar;  // a sheet without a net in it is none
        }
        const std::optional<Backslash> meant = backslashIn(net.name);
        isAnySheet = isAnySheet || meant == Backslash::EndsSheet;
        isAnyBar = isAnyBar || meant == Backslash::Overbar;
    }
    return isAnyBar && !isAnySheet ? Backslash::Overbar : Backslash::EndsSheet;
}

bool hasSheets(const Document& document) {
    const Backslash backslash = backslashOf(document);
    std::string_view first;
    return std::ranges::any_of(document.nets, [&](const Net& net) {
        const std::string_view sheet = sheetOf(net.name, backslash);
        first = first.empty() ? sheet : first;
        return sheet != first && !sheet.empty();
    });
}

NetGroups groupNets(const Document& document, NetGrouping grouping) {
    Gatherer out(document.nets.size());
    switch (grouping) {
        case NetGrouping::Class: gatherByAttribute(document, kClassAttributes, out); break;
        case NetGrouping::DifferentialPair:
            gatherByAttribute(document, kPairAttributes, out);
            gatherPairs(document, out);
            break;
        case NetGrouping::Bus: gatherBuses(document, out); break;
        case NetGrouping::Supply: gatherSupplies(document, out); break;
        case NetGrouping::Sheet: return groupBySheet(document);
    }
    return out.finish();
}

}  // namespace model
