#pragma once

#include <QColor>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/board/layers.h"
#include "model/session/session.h"
#include "ui/common/table_model.h"

namespace ui {

/// How a layer is drawn, as the user edits it.
struct LayerAppearance {
    QColor colour = Qt::gray;
    int opacityPercent = 100;  ///< 0 to 100
    bool isVisible = true;
    bool operator==(const LayerAppearance&) const = default;
};

/// All that the user sets, and undo brings back.
struct LayerSettings {
    std::vector<LayerAppearance> styles;  ///< colours that nobody changed are invalid: they follow the palette
    model::LayerId solo;
    bool operator==(const LayerSettings&) const = default;
};

/// An edit that was made.
struct LayerEdit {
    QString what;  ///< for the undo history
    LayerSettings before;
    LayerSettings after;
    /// Of colours and opacities that change while the user drags: edits of one cell in a row are one step. The same of
    /// what is shown alone, layer after layer, which leaves no step once it has ended. None: -1.
    int cell = -1;
};

/// The layers of a document as an editable table; row n is LayerId n. Styles live here, the document stays frozen. At
/// most one layer is shown alone ("solo"): then it is drawn with the holes through it that have a check mark, without
/// which its pads would be full discs, and nothing else; check marks are untouched when solo ends. Whatever sets
/// visibility ends it, so that its effect is seen.
class LayerModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Visible, Colour, Name, Type, Opacity, Solo };

    explicit LayerModel(QObject* parent = nullptr);

    /// `defaults` has one entry per layer. A null document empties the table.
    void setDocument(std::shared_ptr<const model::Document> document, std::vector<LayerAppearance> defaults);

    /// The same layers with other heights (model::restack); styles stay.
    void setHeights(std::shared_ptr<const model::Document> document);

    /// What the canvas is to draw: `isVisible` has solo worked in.
    [[nodiscard]] std::vector<LayerAppearance> effectiveStyles() const;
    [[nodiscard]] model::LayerId soloLayer() const { return m_solo; }

    void showAll() { showPreset(model::LayerPreset::All); }
    void hideAll() { showPreset(model::LayerPreset::None); }
    void showCopperOnly() { showPreset(model::LayerPreset::Copper); }
    /// These layers and no others, as all that set visibility.
    void showPreset(model::LayerPreset preset);
    /// The layers that are visible when a board is opened.
    void showDefaultSet();
    /// By name; names that no layer has are passed over.
    void showOnly(const std::vector<std::string>& names);
    [[nodiscard]] std::vector<std::string> visibleNames() const;
    /// These and no others.
    void showLayers(std::span<const model::LayerId> layers);
    /// Sets of saved views, for the menu of layer sets.
    void offerSets(std::vector<model::session::LayerSet> sets);
    [[nodiscard]] const std::vector<model::session::LayerSet>& offeredSets() const { return m_offered; }
    /// Shows or hides some, as one edit; none is no edit.
    void setVisible(std::span<const model::LayerId> layers, bool isVisible);
    /// By check marks, one entry per layer.
    [[nodiscard]] std::vector<bool> visibility() const;
    [[nodiscard]] std::vector<bool> defaultVisibility() const;
    /// As a session saves them: colours only where they were changed. Names that no layer has are passed over.
    [[nodiscard]] std::vector<model::session::LayerState> states() const;
    void setStates(const std::vector<model::session::LayerState>& states);
    [[nodiscard]] LayerSettings settings() const;
    /// Without `edited`.
    void setSettings(const LayerSettings& settings);
    /// Other colours to begin with: layers whose colour nobody changed take them.
    void setDefaults(std::vector<LayerAppearance> defaults);
    /// What the user chose of the colours a fabricator offers; the 3D view draws them (ui/layers/board_colour_menu.h).
    void setBoardColours(const model::BoardColourChoice& chosen);
    [[nodiscard]] const model::BoardColourChoice& boardColours() const { return m_boardColours; }
    /// Makes the layer visible; the one shown alone is.
    void show(model::LayerId layer);
    /// Null before the first board.
    [[nodiscard]] const model::Document* document() const { return m_document.get(); }
    /// As drawn, one per layer.
    [[nodiscard]] std::vector<QColor> colours() const;
    /// Back to the styles the document was opened with.
    void restoreDefaults();
    /// Shows `layer` alone; the same layer again, or none, ends it.
    void toggleSolo(model::LayerId layer);

signals:
    /// Comes before `stylesChanged`: colours to begin with may follow from it (setDefaults).
    void boardColoursChanged();
    /// Once per edit, however many layers it concerns.
    void stylesChanged();
    /// The user did this; what came with a board is none.
    void edited(const ui::LayerEdit& edit);

private:
    template <class Change>
    void change(const QString& what, int cell, const Change& apply);
    void setVisibility(const std::vector<bool>& isVisible);
    void announceAllChanged();
    [[nodiscard]] int rows() const override { return static_cast<int>(m_styles.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] Cell settingOf(int row, int column) const;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    bool check(int row, int column, bool isChecked) override;

    std::shared_ptr<const model::Document> m_document;
    std::vector<LayerAppearance> m_defaults;
    std::vector<LayerAppearance> m_styles;
    model::LayerId m_solo;
    std::vector<model::session::LayerSet> m_offered;
    model::BoardColourChoice m_boardColours;
};

/// Has a layer no elements, in copies neither? Dielectrics, say, and sides without components.
[[nodiscard]] bool drawsNothing(const model::Layer& layer);
/// "Copper", "Solder mask", …
[[nodiscard]] QString layerGroupText(model::LayerGroup group);
/// What a layer is for, in words instead of the matrix's capitals: "Signal", "Power plane", …
[[nodiscard]] QString layerTypeText(model::LayerType type);

}  // namespace ui
