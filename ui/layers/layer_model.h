#pragma once

#include <QColor>
#include <memory>
#include <string>
#include <vector>

#include "model/board/document.h"
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

/// The layers of a document as an editable table; row n is LayerId n. Styles live here, the document stays frozen. At
/// most one layer is shown alone ("solo"): then it alone is drawn, whatever the check marks say, and they are untouched
/// when solo ends.
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

    void showAll();
    void hideAll();
    void showCopperOnly();
    /// By name; names that no layer has are passed over.
    void showOnly(const std::vector<std::string>& names);
    [[nodiscard]] std::vector<std::string> visibleNames() const;
    /// As a session saves them: colours only where they were changed. Names that no layer has are passed over.
    [[nodiscard]] std::vector<model::session::LayerState> states() const;
    void setStates(const std::vector<model::session::LayerState>& states);
    /// Other colours to begin with: layers whose colour nobody changed take them.
    void setDefaults(std::vector<LayerAppearance> defaults);
    void show(model::LayerId layer) {
        setData(index(static_cast<int>(layer.row()), Visible), Qt::Checked, Qt::CheckStateRole);
    }
    /// As drawn, one per layer.
    [[nodiscard]] std::vector<QColor> colours() const;
    /// Back to the styles the document was opened with.
    void restoreDefaults();
    /// Shows `layer` alone; the same layer again, or none, ends it.
    void toggleSolo(model::LayerId layer);

signals:
    /// Once per edit, however many layers it concerns.
    void stylesChanged();

private:
    template <class Rule>
    void setVisibility(const Rule& rule);
    void announceAllChanged();
    [[nodiscard]] int rows() const override { return static_cast<int>(m_styles.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    bool check(int row, int column, bool isChecked) override;

    std::shared_ptr<const model::Document> m_document;
    std::vector<LayerAppearance> m_defaults;
    std::vector<LayerAppearance> m_styles;
    model::LayerId m_solo;
};

/// What a layer is for, in words instead of the matrix's capitals: "Signal", "Power plane", …
[[nodiscard]] QString layerTypeText(model::LayerType type);

}  // namespace ui
