#include "ui/workspace/key_presets.h"

#include <QStringList>
#include <algorithm>

namespace ui {

namespace {

using enum ActionId;

struct PresetKeys {
    KeyPreset preset;
    ActionId id;
    const char* keys;  ///< all that the command has, as in ActionSpec::shortcuts
};

constexpr PresetKeys kPresetKeys[] = {
    {KeyPreset::KiCad, Fit, "Home F"},
    {KeyPreset::KiCad, ShowSelection, "Ctrl+Home"},
    {KeyPreset::KiCad, ZoomIn, "F1 Ctrl++ Ctrl+="},
    {KeyPreset::KiCad, ZoomOut, "F2 Ctrl+-"},
    {KeyPreset::KiCad, ShowGuide, "Ctrl+F1"},
    {KeyPreset::KiCad, NextLayer, "+ ="},
    {KeyPreset::KiCad, PreviousLayer, "-"},
    {KeyPreset::KiCad, TopCopper, "PgUp"},
    {KeyPreset::KiCad, BottomCopper, "PgDown"},
    {KeyPreset::KiCad, Contrast, "H Ctrl+H"},
    {KeyPreset::KiCad, SoloLayer, "Shift+H"},
    {KeyPreset::KiCad, ViewTop, "Z T"},
    {KeyPreset::KiCad, ViewBottom, "Shift+Z B"},
    {KeyPreset::KiCad, ShowSolid, "Alt+3 3"},
    {KeyPreset::KiCad, NextUnit, "Ctrl+U"},
    {KeyPreset::KiCad, MeasurePoints, "Ctrl+Shift+M"},
    {KeyPreset::KiCad, HighlightNet, "N `"},  // many keyboards cannot type the backtick alone
    {KeyPreset::KiCad, Redo, "Ctrl+Y Ctrl+Shift+Z"},

    {KeyPreset::Altium, Fit, "V,F V,D Ctrl+PgDown"},
    {KeyPreset::Altium, Flip, "V,B Ctrl+F Space"},
    {KeyPreset::Altium, ShowSelection, "V,E"},
    {KeyPreset::Altium, ExaggerateDielectricHeight, "Shift+V"},
    {KeyPreset::Altium, ZoomIn, "PgUp"},
    {KeyPreset::Altium, ZoomOut, "PgDown"},
    {KeyPreset::Altium, Find, "J,C J,N"},
    {KeyPreset::Altium, ViewTop, "0 T"},
    {KeyPreset::Altium, NextLayer, "+ ="},
    {KeyPreset::Altium, PreviousLayer, "-"},
    {KeyPreset::Altium, SoloLayer, "Shift+S"},
    {KeyPreset::Altium, DrawSection, "Shift+D"},
    {KeyPreset::Altium, ShowLayersDock, "L Ctrl+1"},
    {KeyPreset::Altium, Lens, "Shift+L"},
    {KeyPreset::Altium, MeasurePoints, "Ctrl+M"},
    {KeyPreset::Altium, ClearSelection, "Esc Shift+C"},
    {KeyPreset::Altium, DimOthers, "[ D"},
    {KeyPreset::Altium, NextUnit, "Q"},

    {KeyPreset::Allegro, Fit, "F2 Home"},
    {KeyPreset::Allegro, ZoomIn, "F11 + ="},
    {KeyPreset::Allegro, ZoomOut, "F12 -"},
    {KeyPreset::Allegro, ShowElementDock, "F4 Ctrl+4"},
    {KeyPreset::Allegro, MeasurePoints, "Shift+F4 M"},
    {KeyPreset::Allegro, HighlightNet, "Shift+F8 N"},
    {KeyPreset::Allegro, NextClearance, "Ctrl+F8"},
    {KeyPreset::Allegro, PreviousClearance, "Ctrl+Shift+F8"},
    {KeyPreset::Allegro, Undo, "F8 Ctrl+Z"},
    {KeyPreset::Allegro, ClearSelection, "F9 Esc"},
    {KeyPreset::Allegro, ShowGrid, "F10 G"},

    {KeyPreset::KLayout, Fit, "F2 F"},
    {KeyPreset::KLayout, ShowSelection, "Shift+F2"},
    {KeyPreset::KLayout, ZoomIn, "Return Enter"},
    {KeyPreset::KLayout, ZoomOut, "Shift+Return Shift+Enter"},
};

/// Pressing one would be pressing the other, or the beginning of it.
bool clash(const QKeySequence& a, const QKeySequence& b) {
    return a.matches(b) != QKeySequence::NoMatch || b.matches(a) != QKeySequence::NoMatch;
}

bool isTaken(const QKeySequence& key, KeyPreset preset) {
    return std::ranges::any_of(kPresetKeys, [&](const PresetKeys& row) {
        return row.preset == preset &&
               std::ranges::any_of(keysFrom(row.keys), [&](const QKeySequence& taken) { return clash(taken, key); });
    });
}

}  // namespace

QList<QKeySequence> keysOf(const ActionSpec& spec, KeyPreset preset) {
    const auto* row = std::ranges::find_if(
        kPresetKeys, [&](const PresetKeys& keys) { return keys.preset == preset && keys.id == spec.id; });
    if (row != std::end(kPresetKeys)) {
        return keysFrom(row->keys);
    }
    QList<QKeySequence> keys = keysFrom(spec.shortcuts);
    keys.removeIf([preset](const QKeySequence& key) { return isTaken(key, preset); });
    return keys;
}

QString keysText(const QList<QKeySequence>& keys, const QString& between) {
    QStringList texts;
    for (const QKeySequence& key : keys) {
        texts += key.toString(QKeySequence::NativeText);
    }
    return texts.join(between);
}

MouseHabits mouseHabitsOf(KeyPreset preset) {
    const bool isAltium = preset == KeyPreset::Altium;
    const bool isKLayout = preset == KeyPreset::KLayout;
    return {.rightDragZooms = isKLayout,
            .shiftRightDragOrbits = isAltium,
            .shiftWheel = isAltium || isKLayout ? WheelMove::Sideways : WheelMove::UpAndDown,
            .ctrlWheel = isAltium    ? WheelMove::Zoom
                         : isKLayout ? WheelMove::UpAndDown
                                     : WheelMove::Sideways};
}

}  // namespace ui
