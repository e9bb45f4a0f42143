// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QImage>
#include <QTextBrowser>

namespace espalier {

/// Shows a page of Markdown with its pictures, in the theme's colours and as wide as there is room. Links are
/// told of (anchorClicked) and not followed.
class HelpPage : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpPage(QWidget* parent = nullptr);

    /// Of the page that shows; source() lags behind while sourceChanged is told.
    const QUrl& url() const { return m_url; }
    /// Targets of its links, as they stand in the page, in order.
    QStringList links() const;
    /// Targets of its pictures, likewise.
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
    QHash<QUrl, QImage> m_pictures; ///< As large as they are
    int m_fittedWidth = 0;          ///< px
};

} // namespace espalier
