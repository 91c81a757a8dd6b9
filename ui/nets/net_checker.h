#pragma once

#include <QObject>
#include <memory>

#include "model/nets/net_check.h"
#include "ui/workspace/background_result.h"

namespace ui {

/// Compares the nets of a board with its copper in the background.
class NetChecker : public QObject {
    Q_OBJECT

public:
    explicit NetChecker(QObject* parent = nullptr);

    /// Cancels a check under way.
    void start(std::shared_ptr<const model::Document> board);
    /// Nothing is heard of the check after this.
    void cancel() { m_checks.cancel(); }
    [[nodiscard]] bool isChecking() const { return m_checks.isRunning(); }

signals:
    /// As Background::progressed.
    void progressed(const QString& phase, double fraction);
    void checked(const std::shared_ptr<const model::Document>& board, const std::vector<model::StepCheck>& checks);
    void failed(const QString& reason);

private:
    void deliver();

    BackgroundResult<std::vector<model::StepCheck>> m_checks;
    std::shared_ptr<const model::Document> m_board;
};

}  // namespace ui
