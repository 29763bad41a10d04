/* Asks the terminal whether it shows pictures. Leans on POSIX alone.
 *
 * Every terminal answers the second question (what are you?, DA1), so that one that does not know
 * the first (kitty's, a picture of one pixel) costs no waiting. What is typed in between is not
 * ours: it goes back to the terminal, or where the system forbids that, to whoever reads the next
 * line.
 */
#include "lua/system/term_ask.h"

#include <poll.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static const char question[] = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";

enum { LONGEST_WAIT_MS = 1000, ROOM = 512 };

static struct {
  term_answer answer;
  int known;
  unsigned char typed[ROOM];
  size_t first, count;
} asked;

/* --- reading the answer ----------------------------------------------------------------------- */

/* Length of an answer at `bytes`: ESC _ ... ESC \ or ESC [ ? ... c. 0: it is none; -1: it has not
 * come whole. */
static int answer_at(const unsigned char *bytes, size_t left) {
  if (bytes[0] != 033) return 0;
  if (left < 3) return left == 2 && bytes[1] != '_' && bytes[1] != '[' ? 0 : -1;
  if (bytes[1] == '_' && bytes[2] == 'G') {
    for (size_t i = 3; i + 1 < left; i++)
      if (bytes[i] == 033 && bytes[i + 1] == '\\') return (int)i + 2;
    return -1;
  }
  if (bytes[1] != '[' || bytes[2] != '?') return 0;
  for (size_t i = 3; i < left; i++)
    if (bytes[i] < 0x20 || bytes[i] > 0x3f) return bytes[i] == 'c' ? (int)i + 1 : 0;
  return -1;
}

/* Whether the numbers between ; in ESC [ ? 62 ; 4 c hold a 4: sixels. */
static int has_four(const unsigned char *bytes, int length) {
  for (int i = 4; i + 1 < length; i++)
    if (bytes[i] == '4' && bytes[i - 1] == ';' && (bytes[i + 1] == ';' || bytes[i + 1] == 'c'))
      return 1;
  return 0;
}

static void keep(unsigned char key) {
  if (asked.count < ROOM) asked.typed[asked.count++] = key;
}

/* Takes answers out of what came; other bytes were typed. Returns the bytes used up, and whether
 * the last answer is among them. */
static size_t sort_out(const unsigned char *bytes, size_t count, int *finished) {
  size_t i = 0;
  while (i < count) {
    int length = answer_at(bytes + i, count - i);
    if (length < 0) break;
    if (length == 0) {
      keep(bytes[i++]);
      continue;
    }
    if (bytes[i + 1] == '_')
      asked.answer.kitty = memchr(bytes + i, 'O', (size_t)length) != NULL; /* ...;OK */
    else
      asked.answer.sixel = has_four(bytes + i, length), *finished = 1;
    i += (size_t)length;
  }
  return i;
}

static long milliseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (long)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static int readable(long wait) {
  struct pollfd input = {STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, (int)(wait > 0 ? wait : 0)) > 0 && (input.revents & POLLIN);
}

static void read_answer(void) {
  unsigned char bytes[ROOM];
  size_t count = 0;
  int finished = 0;
  long until = milliseconds() + LONGEST_WAIT_MS;
  while (!finished && count < sizeof bytes && readable(until - milliseconds())) {
    ssize_t got = read(STDIN_FILENO, bytes + count, sizeof bytes - count);
    if (got <= 0) break;
    count += (size_t)got;
    size_t used = sort_out(bytes, count, &finished);
    memmove(bytes, bytes + used, count - used);
    count -= used;
  }
  for (size_t i = 0; i < count; i++) keep(bytes[i]);
}

/* --- asking ----------------------------------------------------------------------------------- */

/* In the background the question would stop us. */
static int may_ask(void) {
  return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

/* Types the keys again, as if they came now; all or, where the system forbids it, none. */
static void give_back(void) {
  if (asked.count > 0 && ioctl(STDIN_FILENO, TIOCSTI, &asked.typed[0]) == 0) {
    for (size_t i = 1; i < asked.count; i++) ioctl(STDIN_FILENO, TIOCSTI, &asked.typed[i]);
    asked.count = 0;
  }
}

/* Keys as they come, without echo; Ctrl-C stays a signal. */
static void ask(const struct termios *before) {
  struct termios raw = *before;
  raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  if (tcsetattr(STDIN_FILENO, TCSADRAIN, &raw) != 0) return;
  if (!readable(0) && write(STDOUT_FILENO, question, sizeof question - 1) > 0) {
    read_answer();
    asked.known = 1;
  }
  tcsetattr(STDIN_FILENO, TCSADRAIN, before);
  give_back();
}

term_answer term_ask_pictures(void) {
  struct termios before;
  if (!asked.known && may_ask() && tcgetattr(STDIN_FILENO, &before) == 0) ask(&before);
  return asked.answer;
}

int term_ask_typed(void) {
  return asked.first < asked.count ? asked.typed[asked.first++] : -1;
}
