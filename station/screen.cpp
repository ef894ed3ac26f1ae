#include "station/screen.hpp"

#include <curses.h>

#include <clocale>
#include <cstdio>
#include <stdexcept>
#include <unistd.h>

namespace windlass::station {

namespace {

enum Colour : short { kGreen = 1, kYellow, kRed, kGrey };

attr_t attributes(Style style) {
    const bool colour = has_colors();
    switch (style) {
    case Style::plain:
        return A_NORMAL;
    case Style::title:
        return A_REVERSE;
    case Style::label:
        return A_DIM;
    case Style::good:
        return A_BOLD | (colour ? COLOR_PAIR(kGreen) : A_NORMAL);
    case Style::caution:
        return A_BOLD | (colour ? COLOR_PAIR(kYellow) : A_UNDERLINE);
    case Style::alarm:
        return A_BOLD | A_REVERSE | (colour ? COLOR_PAIR(kRed) : A_NORMAL);
    case Style::stale:
        return A_DIM | (colour ? COLOR_PAIR(kGrey) : A_NORMAL);
    }
    return A_NORMAL;
}

} // namespace

Screen::Screen() {
    if (!isatty(STDOUT_FILENO)) throw std::runtime_error("the full-screen view needs a terminal");
    std::setlocale(LC_ALL, "");
    // newterm instead of initscr: initscr ends the program when TERM is unknown.
    if (!newterm(nullptr, stdout, stdin))
        throw std::runtime_error("the full-screen view cannot use this terminal: is TERM set?");
    cbreak();
    noecho();
    keypad(stdscr, TRUE);
    curs_set(0);
    if (has_colors()) {
        start_color();
        use_default_colors();
        init_pair(kGreen, COLOR_GREEN, -1);
        init_pair(kYellow, COLOR_YELLOW, -1);
        init_pair(kRed, COLOR_RED, -1);
        init_pair(kGrey, COLOR_BLUE, -1);
    }
}

Screen::~Screen() {
    endwin();
}

int Screen::width() const {
    return getmaxx(stdscr);
}
int Screen::height() const {
    return getmaxy(stdscr);
}

void Screen::draw(const std::vector<Piece>& pieces) {
    erase();
    for (const Piece& piece : pieces) {
        attrset(attributes(piece.style));
        mvaddstr(piece.row, piece.column, piece.text.c_str());
    }
    attrset(A_NORMAL);
    refresh();
}

std::optional<int> Screen::key(int milliseconds) {
    const auto special = [](Key key) { return std::optional<int>{static_cast<int>(key)}; };
    timeout(milliseconds);
    switch (const int code = getch()) {
    case ERR:
    case KEY_RESIZE:
        return std::nullopt;
    case KEY_UP:
        return special(Key::up);
    case KEY_DOWN:
        return special(Key::down);
    case KEY_LEFT:
        return special(Key::left);
    case KEY_RIGHT:
        return special(Key::right);
    case KEY_PPAGE:
        return special(Key::page_up);
    case KEY_NPAGE:
        return special(Key::page_down);
    case KEY_HOME:
        return special(Key::home);
    case KEY_END:
        return special(Key::end);
    case KEY_F(2):
        return special(Key::f2);
    case KEY_F(3):
        return special(Key::f3);
    default:
        return code;
    }
}

} // namespace windlass::station
