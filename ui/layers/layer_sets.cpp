#include "ui/layers/layer_sets.h"

#include <QInputDialog>
#include <algorithm>

#include "ui/common/panel_parts.h"

namespace ui {

namespace session = model::session;

namespace {

struct Preset {
    ActionId action;
    model::LayerPreset preset;
};
constexpr Preset kPresets[] = {{ActionId::ShowAllLayers, model::LayerPreset::All},
                               {ActionId::HideAllLayers, model::LayerPreset::None},
                               {ActionId::ShowCopperOnly, model::LayerPreset::Copper},
                               {ActionId::ShowTopLayers, model::LayerPreset::Top},
                               {ActionId::ShowBottomLayers, model::LayerPreset::Bottom},
                               {ActionId::ShowInnerLayers, model::LayerPreset::Inner},
                               {ActionId::ShowAssemblyLayers, model::LayerPreset::Assembly},
                               {ActionId::ShowFabricationLayers, model::LayerPreset::Fabrication}};

QString plainText(const QAction& action) {
    return action.text().remove('&');
}

}  // namespace

LayerSets::LayerSets(LayerModel& layers, Workspace& workspace, ActionSet& actions, QWidget& window)
    : QObject(&window),
      m_layers(layers),
      m_workspace(workspace),
      m_actions(actions),
      m_window(window),
      m_part(
          workspace, tr("The layer sets"),
          [this](const List& sets) {
              m_own = sets;
              emit changed();
          },
          session::saveLayerSets) {
    for (const Preset& preset : kPresets) {
        connect(&actions[preset.action], &QAction::triggered, this,
                [this, preset] { m_layers.showPreset(preset.preset); });
    }
    connect(&actions[ActionId::ShowDefaultLayers], &QAction::triggered, &layers, &LayerModel::showDefaultSet);
    connect(&actions[ActionId::SaveLayerSet], &QAction::triggered, this, &LayerSets::requestName);
    connect(&m_menu, &QMenu::aboutToShow, this, &LayerSets::fillMenu);
    connect(&layers, &LayerModel::stylesChanged, this, &LayerSets::changed);
    connect(&workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        if (m_part.open()) {
            m_own = board.session.layerSets;
            emit changed();
        }
    });
}

QString LayerSets::shownName() const {
    const model::Document* document = m_layers.document();
    if (document == nullptr) {
        return {};
    }
    if (const model::LayerId alone = m_layers.soloLayer(); alone.isValid()) {
        return tr("Only %1").arg(QString::fromStdString(document->layer(alone).name));
    }
    const std::vector<bool> visible = m_layers.visibility();
    if (visible == m_layers.defaultVisibility()) {
        return plainText(m_actions[ActionId::ShowDefaultLayers]);
    }
    for (const Preset& preset : kPresets) {
        if (visible == model::layersOf(*document, preset.preset)) {
            return plainText(m_actions[preset.action]);
        }
    }
    for (const List* sets : {&m_own, &m_layers.offeredSets()}) {
        for (const session::LayerSet& set : *sets) {
            if (isShown(set.layers)) {
                return QString::fromStdString(set.name);
            }
        }
    }
    return {};
}

bool LayerSets::isShown(const std::vector<std::string>& names) const {
    if (m_layers.soloLayer().isValid()) {
        return false;
    }
    const std::vector<bool> visible = m_layers.visibility();
    for (std::size_t row = 0; row < visible.size(); ++row) {
        const bool isIn = std::ranges::find(names, m_layers.document()->layers[row].name) != names.end();
        if (visible[row] != isIn) {
            return false;
        }
    }
    return true;
}

void LayerSets::requestName() {
    auto* dialog = new QInputDialog(&m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save layer set"));
    dialog->setLabelText(tr("Name of the set of visible layers:"));
    dialog->setTextValue(QString::fromStdString(freeName(m_own, tr("Set").toStdString() + ' ')));
    connect(dialog, &QInputDialog::textValueSelected, this, &LayerSets::save);
    dialog->open();
}

void LayerSets::save(const QString& name) {
    if (name.trimmed().isEmpty() || m_layers.document() == nullptr) {
        return;
    }
    List after = m_own;
    session::LayerSet set{name.trimmed().toStdString(), m_layers.visibleNames()};
    const auto same = std::ranges::find(after, set.name, &session::LayerSet::name);
    const bool isReplaced = same != after.end();
    if (isReplaced) {
        *same = std::move(set);
    } else {
        after.push_back(std::move(set));
    }
    m_part.edit(isReplaced ? tr("replacing a layer set") : tr("saving a layer set"), m_own, std::move(after));
    m_workspace.report(
        (isReplaced ? tr("Replaced the layer set %1") : tr("Saved the layer set %1")).arg(name.trimmed()));
}

void LayerSets::remove(const QString& name) {
    List after = m_own;
    std::erase_if(after, [&](const session::LayerSet& set) { return set.name == name.toStdString(); });
    m_part.edit(tr("deleting a layer set"), m_own, std::move(after));
}

void LayerSets::addSet(const session::LayerSet& set) {
    QAction* show = m_menu.addAction(QString::fromStdString(set.name).replace('&', QLatin1String("&&")),
                                     [this, layers = set.layers] { m_layers.showOnly(layers); });
    show->setCheckable(true);
    show->setChecked(isShown(set.layers));
}

void LayerSets::fillMenu() {
    clearMenu(m_menu);
    if (m_layers.document() == nullptr) {
        return;
    }
    m_menu.addAction(&m_actions[ActionId::ShowDefaultLayers]);
    for (const Preset& preset : kPresets) {
        m_menu.addAction(&m_actions[preset.action]);
    }
    if (!m_own.empty()) {
        m_menu.addSection(tr("Own sets"));
        std::ranges::for_each(m_own, [this](const auto& set) { addSet(set); });
    }
    if (!m_layers.offeredSets().empty()) {
        m_menu.addSection(tr("Saved views"));
        std::ranges::for_each(m_layers.offeredSets(), [this](const auto& set) { addSet(set); });
    }
    m_menu.addSeparator();
    m_menu.addAction(&m_actions[ActionId::SaveLayerSet]);
    if (!m_own.empty()) {
        QMenu* menu = m_menu.addMenu(tr("Delete set"));
        for (const session::LayerSet& set : m_own) {
            const QString name = QString::fromStdString(set.name);
            menu->addAction(name, this, [this, name] { remove(name); });
        }
    }
}

}  // namespace ui
