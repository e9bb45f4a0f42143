// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HelpPage.h"

#include "panels/Theme.h"

#include <QEvent>
#include <QFile>
#include <QFontDatabase>
#include <QPainter>
#include <QPainterPath>
#include <QScroller>
#include <QTextBlock>
#include <QTextDocumentFragment>
#include <QTextTable>

#include <algorithm>
#include <array>

namespace espalier {

namespace {

constexpr int kPageMargin = 18;      ///< Around the text, px
constexpr double kPictureRadius = 8; ///< Of a picture's corners, px
constexpr double kLineHeight = 132;  ///< %
/// Font sizes of headings by level, relative to the text.
constexpr std::array kHeadingSizes{1.0, 1.75, 1.22, 1.06};

/// Calls @p visit(position, length, format) for each run of text of the same format.
template <class Visit>
void visitFragments(const QTextDocument& document, Visit&& visit)
{
    struct Run {
        int position;
        int length;
        QTextCharFormat format;
    };
    // @p visit can change the text, which invalidates the document's iterators.
    std::vector<Run> runs;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            runs.push_back({fragment.position(), fragment.length(), fragment.charFormat()});
        }
    }
    for (const Run& run : runs)
        visit(run.position, run.length, run.format);
}

bool hasPicture(const QTextBlock& block)
{
    for (auto it = block.begin(); !it.atEnd(); ++it) {
        if (it.fragment().charFormat().isImageFormat())
            return true;
    }
    return false;
}

/// Whether it is a line of a block of code.
bool isCode(const QTextBlock& block)
{
    return block.isValid() && block.blockFormat().hasProperty(QTextFormat::BlockCodeFence);
}

/// Distance between a block and the next one, px.
double spaceBelow(const QTextBlock& block)
{
    const QTextBlock next = block.next();
    const int level = block.blockFormat().headingLevel();
    if (level > 0)
        return level == 1 ? 10.0 : 4.0;
    if (QTextCursor(block).currentTable() || (isCode(block) && isCode(next)))
        return 0.0;
    return block.textList() && next.isValid() && next.textList() ? 4.0 : 10.0;
}

/// As wide as @p width px of a screen of that @p ratio, with round corners.
QImage fitted(const QImage& picture, int width, double ratio)
{
    const int pixels = std::max(1, static_cast<int>(width * ratio));
    const QImage scaled = picture.scaledToWidth(pixels, Qt::SmoothTransformation);
    QImage rounded(scaled.size(), QImage::Format_ARGB32_Premultiplied);
    rounded.fill(Qt::transparent);
    QPainter painter(&rounded);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(rounded.rect()), kPictureRadius * ratio, kPictureRadius * ratio);
    painter.setClipPath(outline);
    painter.drawImage(0, 0, scaled);
    painter.end();
    rounded.setDevicePixelRatio(ratio);
    return rounded;
}

} // namespace

HelpPage::HelpPage(QWidget* parent) : QTextBrowser(parent)
{
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAccessibleName(tr("Help page"));
    viewport()->setAutoFillBackground(false);
    document()->setDocumentMargin(kPageMargin);
    document()->setIndentWidth(24.0);
    connect(this, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
        m_url = url;
        m_pictures.clear();
        dress();
    });
    // A finger drags the page.
    QScroller::grabGesture(viewport(), QScroller::TouchGesture);
}

QStringList HelpPage::links() const
{
    QStringList targets;
    visitFragments(*document(), [&](int, int, const QTextCharFormat& format) {
        if (format.isAnchor() && !format.anchorHref().isEmpty())
            targets.append(format.anchorHref());
    });
    targets.removeDuplicates();
    return targets;
}

QStringList HelpPage::pictures() const
{
    QStringList targets;
    visitFragments(*document(), [&](int, int, const QTextCharFormat& format) {
        if (format.isImageFormat())
            targets.append(format.toImageFormat().name());
    });
    return targets;
}

QVariant HelpPage::loadResource(int type, const QUrl& name)
{
    if (type != QTextDocument::ImageResource)
        return QTextBrowser::loadResource(type, name);
    const QImage picture = QImage::fromData(QTextBrowser::loadResource(type, name).toByteArray());
    m_pictures.insert(name, picture);
    return picture;
}

void HelpPage::changeEvent(QEvent* event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        dress();
}

void HelpPage::resizeEvent(QResizeEvent* event)
{
    QTextBrowser::resizeEvent(event);
    fitPictures();
}

void HelpPage::dress()
{
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        QTextBlockFormat shape;
        if (isCode(block)) {
            shape.setBackground(theme::kSunken);
            shape.setNonBreakableLines(false);
        } else if (!hasPicture(block)) {
            shape.setLineHeight(kLineHeight, QTextBlockFormat::ProportionalHeight);
        }
        shape.setTopMargin(level == 0 ? 0.0 : level == 1 ? 2.0 : 20.0);
        shape.setBottomMargin(spaceBelow(block));
        cursor.setPosition(block.position());
        cursor.mergeBlockFormat(shape);
    }
    visitFragments(*document(), [&](int position, int length, const QTextCharFormat& format) {
        QTextCharFormat letters = format;
        const int level = document()->findBlock(position).blockFormat().headingLevel();
        if (level > 0) {
            const auto size = std::min(static_cast<std::size_t>(level), kHeadingSizes.size() - 1);
            letters.clearProperty(QTextFormat::FontSizeAdjustment);
            letters.setFontPointSize(font().pointSizeF() * kHeadingSizes[size]);
            letters.setFontWeight(level == 1 ? QFont::Normal : QFont::DemiBold);
            letters.setForeground(level == 1 ? theme::kText : theme::kHandle);
        } else if (format.isAnchor()) {
            letters.setForeground(theme::kAccent);
            letters.setFontUnderline(false);
            letters.setFontWeight(QFont::DemiBold);
        } else if (isCode(document()->findBlock(position))) {
            letters.setFontFamilies({QFontDatabase::systemFont(QFontDatabase::FixedFont).family()});
            letters.setFontPointSize(font().pointSizeF() * 0.92);
            letters.clearBackground();
        } else if (format.fontFixedPitch()) {
            // Code is mostly names of keys: they get a background to distinguish them from the text.
            letters.setFontFamilies({font().family()});
            letters.setFontFixedPitch(false);
            letters.setForeground(theme::kHandle);
            letters.setBackground(theme::kKeyCap);
        } else {
            return;
        }
        cursor.setPosition(position);
        cursor.setPosition(position + length, QTextCursor::KeepAnchor);
        cursor.setCharFormat(letters);
    });
    dressTables();
    cursor.endEditBlock();
    m_fittedWidth = 0;
    fitPictures();
}

void HelpPage::dressTables()
{
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table)
            continue;
        QTextTableFormat shape = table->format();
        shape.setBorder(0.0);
        shape.setCellSpacing(0.0);
        shape.setCellPadding(5.0);
        shape.setTopMargin(8.0);
        shape.setBottomMargin(12.0);
        shape.setWidth(QTextLength(QTextLength::PercentageLength, 100.0));
        table->setFormat(shape);
        for (int row = 0; row < table->rows(); ++row) {
            for (int column = 0; column < table->columns(); ++column) {
                QTextTableCell cell = table->cellAt(row, column);
                QTextTableCellFormat look;
                look.setBackground(row % 2 == 0 ? QBrush(theme::kSunken) : QBrush(Qt::NoBrush));
                if (row == 0)
                    look.setForeground(theme::kDimText);
                cell.setFormat(look);
            }
        }
    }
}

void HelpPage::fitPictures()
{
    const int room = viewport()->width() - 2 * kPageMargin;
    if (room == m_fittedWidth || room <= 0)
        return;
    m_fittedWidth = room;
    visitFragments(*document(), [&](int position, int length, const QTextCharFormat& format) {
        if (!format.isImageFormat())
            return;
        QTextImageFormat image = format.toImageFormat();
        const QUrl name(image.name());
        if (!m_pictures.contains(name))
            loadResource(QTextDocument::ImageResource, name);
        const QImage picture = m_pictures.value(name);
        if (picture.isNull())
            return;
        const int width = std::min(room, picture.width());
        document()->addResource(QTextDocument::ImageResource, document()->baseUrl().resolved(name),
                                fitted(picture, width, devicePixelRatioF()));
        image.setWidth(width);
        image.setHeight(static_cast<double>(width) * picture.height() / picture.width());
        QTextCursor cursor(document());
        cursor.setPosition(position);
        cursor.setPosition(position + length, QTextCursor::KeepAnchor);
        cursor.setCharFormat(image);
    });
}

} // namespace espalier
