#include "ui/workspace/settings.h"

#include <QDir>
#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kTheme = "view/theme";
constexpr auto kBackend = "view/backend";
constexpr auto kArrangement = "view/arrangement";
constexpr auto kUnit = "view/unit";
constexpr auto kPalette = "view/palette";
constexpr auto kKeys = "view/keys";
constexpr auto kRecent = "files/recent";
constexpr auto kFolder = "files/folder";

template <class Value>
struct Word {
    Value value;
    const char* word;
};

constexpr std::array<Word<Theme>, 3> kThemes{
    {{Theme::System, "system"}, {Theme::Dark, "dark"}, {Theme::Light, "light"}}};
constexpr std::array<Word<Arrangement>, 4> kArrangements{{{Arrangement::SideBySide, "side by side"},
                                                          {Arrangement::Stacked, "stacked"},
                                                          {Arrangement::Flat, "2d"},
                                                          {Arrangement::Solid, "3d"}}};
constexpr std::array<Word<LengthUnit>, 3> kUnits{
    {{LengthUnit::Millimetre, "mm"}, {LengthUnit::Mil, "mil"}, {LengthUnit::Inch, "inch"}}};
constexpr std::array<Word<render::Backend>, 5> kBackends{{{render::Backend::Auto, "auto"},
                                                          {render::Backend::Mesh, "mesh"},
                                                          {render::Backend::Pull, "pull"},
                                                          {render::Backend::Impostor, "impostor"},
                                                          {render::Backend::Raster, "raster"}}};
constexpr std::array<Word<render::Palette>, 2> kPalettes{
    {{render::Palette::Standard, "standard"}, {render::Palette::ColourBlindSafe, "colour-blind safe"}}};
constexpr std::array<Word<KeyPreset>, 5> kKeyPresets{{{KeyPreset::Copperscope, "copperscope"},
                                                      {KeyPreset::KiCad, "kicad"},
                                                      {KeyPreset::Altium, "altium"},
                                                      {KeyPreset::Allegro, "allegro"},
                                                      {KeyPreset::KLayout, "klayout"}}};

/// The first entry stands for whatever is not in the table: settings may come from another version.
template <class Table>
auto fromWord(const Table& table, const QString& word) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const auto& entry) { return word == QLatin1String(entry.word); });
    return found == table.end() ? table.front().value : found->value;
}

template <class Table, class Value>
QString toWord(const Table& table, Value value) {
    return QLatin1String(
        std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.value == value; })->word);
}

}  // namespace

Settings::Settings() : m_store(QStringLiteral("Copperscope"), QStringLiteral("Copperscope")) {}

Settings::Settings(const QString& iniFile) : m_store(iniFile, QSettings::IniFormat) {}

QByteArray Settings::windowGeometry() const {
    return m_store.value(kGeometry).toByteArray();
}

QByteArray Settings::windowState() const {
    return m_store.value(kState).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    m_store.setValue(kGeometry, geometry);
    m_store.setValue(kState, state);
}

Theme Settings::theme() const {
    return fromWord(kThemes, m_store.value(kTheme).toString());
}

void Settings::setTheme(Theme theme) {
    m_store.setValue(kTheme, toWord(kThemes, theme));
}

render::Backend Settings::backend() const {
    return fromWord(kBackends, m_store.value(kBackend).toString());
}

void Settings::setBackend(render::Backend backend) {
    m_store.setValue(kBackend, toWord(kBackends, backend));
}

Arrangement Settings::arrangement() const {
    return fromWord(kArrangements, m_store.value(kArrangement).toString());
}

void Settings::setArrangement(Arrangement arrangement) {
    m_store.setValue(kArrangement, toWord(kArrangements, arrangement));
}

LengthUnit Settings::unit() const {
    return fromWord(kUnits, m_store.value(kUnit).toString());
}

void Settings::setUnit(LengthUnit unit) {
    m_store.setValue(kUnit, toWord(kUnits, unit));
}

render::Palette Settings::palette() const {
    return fromWord(kPalettes, m_store.value(kPalette).toString());
}

void Settings::setPalette(render::Palette palette) {
    m_store.setValue(kPalette, toWord(kPalettes, palette));
}

KeyPreset Settings::keys() const {
    return fromWord(kKeyPresets, m_store.value(kKeys).toString());
}

void Settings::setKeys(KeyPreset keys) {
    m_store.setValue(kKeys, toWord(kKeyPresets, keys));
}

QStringList Settings::recentBoards() const {
    return m_store.value(kRecent).toStringList();
}

void Settings::setRecentBoards(const QStringList& paths) {
    m_store.setValue(kRecent, paths);
}

QString Settings::lastFolder() const {
    return m_store.value(kFolder, QDir::homePath()).toString();
}

void Settings::setLastFolder(const QString& folder) {
    m_store.setValue(kFolder, folder);
}

void Settings::reset() {
    m_store.clear();
}

}  // namespace ui
