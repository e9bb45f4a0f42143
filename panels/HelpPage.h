// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QImage>
#include <QTextBrowser>

namespace espalier {

/// Shows a page of Markdown with its pictures, in the theme's colours and as wide as there is room. A click
/// on a link emits anchorClicked; the widget does not follow it.
class HelpPage : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpPage(QWidget* parent = nullptr);

    /// URL of the page that shows; source() still has the old value while sourceChanged is emitted.
    const QUrl& url() const { return m_url; }
    /// Targets of the page's links, as written in the page, in order.
    QStringList links() const;
    /// Targets of the page's pictures, as written in the page, in order.
    QStringList pictures() const;
    QVariant loadResource(int type, const QUrl& name) override;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void dress();
    void dressTables();
    void fitPictures();

    QUrl m_url;
    QHash<QUrl, QImage> m_pictures; ///< In their full size
    int m_fittedWidth = 0;          ///< px
};

} // namespace espalier
