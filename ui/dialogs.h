#pragma once

#include <QString>
#include <functional>

class QWidget;

/// Questions to the user. None of them blocks: the answer comes by the callback, or never if the dialog is closed.
namespace ui {

using PathAnswer = std::function<void(const QString&)>;

enum class BoardForm { File, Folder };

void askForBoard(QWidget& parent, BoardForm form, const QString& startFolder, const PathAnswer& answer);
void askForPicturePath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
/// How wide a picture is to be, in pixels; `width` is proposed, `most` the limit.
void askForWidth(QWidget& parent, int width, int most, const std::function<void(int)>& answer);
void askForTablePath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
void askForStackPath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
void askForSectionPath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
void askForRulesToOpen(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
/// Text, a table or JSON, by the ending.
void askForReportPath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
void askForRulesPath(QWidget& parent, const QString& startFolder, const PathAnswer& answer);
void askToReset(QWidget& parent, const std::function<void()>& confirmed);

}  // namespace ui
