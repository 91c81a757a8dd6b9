#pragma once

#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/export/export_dialog.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// File, Export: a dialog of what is written, with about how large that will be, and the writing in the background.
/// What is not in the file is listed in Messages.
class ExportFeature : public QObject {
    Q_OBJECT

public:
    explicit ExportFeature(FeatureContext& context);

private:
    void ask();
    [[nodiscard]] ExportSource source() const;
    void estimate();
    void showEstimate();
    void write();
    void reportWritten();
    [[nodiscard]] std::vector<model::SolidLook> looks(const model::ExportFormat& format) const;

    FeatureContext& m_context;
    Workspace& m_workspace;
    QPointer<ExportDialog> m_dialog;
    QTimer m_due;  ///< runs out when nothing was changed in the dialog for a moment
    BackgroundResult<std::optional<model::StepEstimate>> m_estimate;
    BackgroundResult<model::ExportSummary> m_export;
    QString m_path;               ///< of the file that is being written, or was the last
    bool m_isOfThisBoard = true;  ///< it is of the board on the screen
};

}  // namespace ui
