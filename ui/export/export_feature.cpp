#include "ui/export/export_feature.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/common/paths.h"
#include "ui/views/board_views.h"
#include "ui/views/layer_styles.h"

namespace ui {

namespace {

constexpr int kEstimateAfterMs = 300;

QString sizeText(double bytes) {
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

QString textOf(const model::StepEstimate& estimate) {
    return ExportFeature::tr("About %1, %2 s").arg(sizeText(estimate.bytes)).arg(std::ceil(estimate.seconds));
}

std::vector<std::string> namesOf(const model::StepTree& tree, const std::vector<model::BoardNet>& nets) {
    std::vector<std::string> names;
    for (const model::BoardNet& net : nets) {
        names.push_back(tree.steps[net.step]->nets[net.net.row()].name);
    }
    return names;
}

std::vector<std::string> allNames(const model::StepTree& tree) {
    std::vector<std::string> names;
    for (const model::Document* step : tree.steps) {
        for (const model::Net& net : step->nets) {
            names.push_back(net.name);
        }
    }
    return names;
}

model::Diagnostics messagesOf(const std::vector<model::NotExported>& missing, const QString& path) {
    model::Diagnostics messages;
    const std::string start = "Not in " + QFileInfo(path).fileName().toStdString() + ": ";
    for (const model::NotExported& item : missing) {
        messages.report(model::Severity::Warning, item.file, item.line, start + item.reason, item.element);
    }
    return messages;
}

}  // namespace

ExportFeature::ExportFeature(FeatureContext& context)
    : QObject(&context.window), m_context(context), m_workspace(context.workspace) {
    m_due.setSingleShot(true);
    m_due.setInterval(kEstimateAfterMs);
    connect(&m_due, &QTimer::timeout, this, &ExportFeature::estimate);
    connect(&m_estimate.background(), &Background::finished, this, &ExportFeature::showEstimate);
    connect(&m_export.background(), &Background::finished, this, &ExportFeature::reportWritten);
    connect(&m_export.background(), &Background::cancelled, this,
            [this] { m_workspace.report(tr("Stopped: %1 was not written").arg(m_path)); });
    connect(&m_workspace, &Workspace::boardLeaves, this, [this] { m_isOfThisBoard = false; });
    m_workspace.watchWriting(m_export.background(), [this] { return QFileInfo(m_path).fileName(); });
    context.on(ActionId::ExportBoard, this, [this] { ask(); });
    context.on(ActionId::PrintBoard, this, [this] {
        ask();
        if (m_dialog) {
            m_dialog->choose(*std::ranges::find_if(model::exportFormats(), &model::ExportFormat::isPdf));
        }
    });
}

void ExportFeature::ask() {
    if (m_export.isRunning()) {
        m_workspace.report(tr("%1 is still being written; Esc stops it").arg(m_path));
        return;
    }
    m_dialog = new ExportDialog(source(), m_context.settings, &m_context.window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &ExportDialog::changed, this, [this] {
        m_estimate.cancel();
        m_dialog->setEstimate(tr("Estimating the size …"));
        m_due.start();
    });
    connect(m_dialog, &QDialog::finished, this, [this] {
        m_due.stop();
        m_estimate.cancel();
    });
    connect(m_dialog, &QDialog::accepted, this, &ExportFeature::write);
    connect(m_dialog, &ExportDialog::pictureWanted, this,
            [this] { m_context.actions[ActionId::SavePicture].trigger(); });
    m_dialog->open();
    emit m_dialog->changed();
}

ExportSource ExportFeature::source() const {
    const SelectionModel& selection = m_workspace.selection();
    const BoardView& flat = m_context.views.flat();
    const QSizeF size = flat.controller().viewport();
    std::optional<base::Box> window;
    if (flat.isVisible()) {
        window = flat.boxBetween({}, {size.width(), size.height()});
    }
    return {QFileInfo(displayName(m_workspace.board()->request.path)).completeBaseName(),
            m_workspace.boardFolder(),
            m_context.layers,
            allNames(selection.tree()),
            namesOf(selection.tree(), selection.selectionNets()),
            window,
            m_workspace.unit()};
}

void ExportFeature::estimate() {
    if (!m_dialog->isReady()) {
        m_dialog->setEstimate({});
        return;
    }
    m_estimate.run([board = m_workspace.board()->document, &format = m_dialog->format(), request = m_dialog->request()](
                       base::Progress& progress) { return model::estimateExport(*board, format, request, progress); },
                   tr("Estimating"), tr("There is not enough memory to estimate the size."));
}

void ExportFeature::showEstimate() {
    const base::Result<std::optional<model::StepEstimate>> estimate = m_estimate.take();
    if (m_dialog) {
        m_dialog->setEstimate(!estimate   ? QString::fromStdString(estimate.error().text)
                              : *estimate ? textOf(**estimate)
                                          : tr("The size is known once it is written"));
    }
}

/// Solids as the 3D view has them, drawings as the 2D view: outer copper under a finish would be of one colour there.
std::vector<model::SolidLook> ExportFeature::looks(const model::ExportFormat& format) const {
    const LayerModel& layers = m_context.layers;
    const std::vector<LayerAppearance> appearances = layers.effectiveStyles();
    const std::vector<render::LayerStyle> styles =
        format.isSolid ? solidStyles(*layers.document(), appearances, m_context.settings.choice<render::Palette>(),
                                     layers.boardColours())
                       : flatStyles(*layers.document(), appearances);
    std::vector<model::SolidLook> looks;
    for (const render::LayerStyle& style : styles) {
        const auto byte = [](float value) { return static_cast<std::uint32_t>(std::lround(value * 255.0F)); };
        looks.push_back({byte(style.colour.r) << 16U | byte(style.colour.g) << 8U | byte(style.colour.b),
                         static_cast<double>(style.opacity)});
    }
    return looks;
}

void ExportFeature::write() {
    model::ExportRequest request = m_dialog->request();
    request.looks = looks(m_dialog->format());
    request.time = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    m_path = m_dialog->path();
    m_isOfThisBoard = true;
    m_export.run([board = m_workspace.board()->document, &format = m_dialog->format(), request = std::move(request),
                  path = toPath(m_path)](
                     base::Progress& progress) { return model::exportBoard(*board, format, request, path, progress); },
                 tr("Exporting"), tr("There is not enough memory to export that much."));
}

void ExportFeature::reportWritten() {
    const base::Result<model::ExportSummary> summary = m_export.take();
    if (!summary) {
        m_workspace.reportError(tr("Nothing was exported. %1").arg(QString::fromStdString(summary.error().text)));
        return;
    }
    if (m_isOfThisBoard) {  // else they would name elements of another one
        m_workspace.listExported(messagesOf(summary->missing, m_path));
    }
    const QString missing =
        summary->missing.empty() ? QString()
        : m_isOfThisBoard ? tr(". Elements that are not in it: %L1, listed in Messages").arg(summary->missing.size())
                          : tr(". Elements that are not in it: %L1").arg(summary->missing.size());
    m_workspace.report(tr("Saved %1: %2, %3%4")
                           .arg(m_path, QString::fromStdString(summary->content),
                                sizeText(static_cast<double>(summary->bytes)), missing));
}

}  // namespace ui
