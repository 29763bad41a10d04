/* Queries the terminal for two kinds of graphics: kitty's protocol (query with an image of one
 * pixel) and sixel (device attributes, DA1). Every terminal answers DA1, so the program need not
 * wait for terminals without kitty's protocol. Keys typed during the query are pushed back to the
 * terminal. If the system forbids this, term_query_next_key returns the keys. */
#include "lua/system/term_query.h"

#include <poll.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static const char question[] = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";

enum { LONGEST_WAIT_MS = 1000, MOST_KEYS = 512 };

static struct {
  term_answer answer;
  int known;
  unsigned char typed[MOST_KEYS];
  size_t first, count;
} asked;

/* --- reading the reply ------------------------------------------------------------------------ */

/* Returns the length of the terminal's reply at `bytes`, which has the form ESC _ ... ESC \ or
 * ESC [ ? ... c. Returns 0 if there is no reply, and -1 if the reply is incomplete. */
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

/* Returns true if the attributes in a reply such as ESC [ ? 62 ; 4 c include 4, which means sixel
 * graphics. */
static int has_four(const unsigned char *bytes, int length) {
  for (int i = 4; i + 1 < length; i++)
    if (bytes[i] == '4' && bytes[i - 1] == ';' && (bytes[i + 1] == ';' || bytes[i + 1] == 'c'))
      return 1;
  return 0;
}

static void keep(unsigned char key) {
  if (asked.count < MOST_KEYS) asked.typed[asked.count++] = key;
}

/* Separates the terminal's replies from typed keys. Returns the number of processed bytes. Sets
 * *finished to true if the reply to DA1 is among them. */
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
      asked.answer.kitty = memchr(bytes + i, 'O', (size_t)length) != NULL; /* reply "...;OK" */
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
  unsigned char bytes[MOST_KEYS];
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

/* --- query ------------------------------------------------------------------------------------ */

/* Returns true for a foreground process on a terminal. In a background process, reading from the
 * terminal would suspend the process. */
static int may_query(void) {
  return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

/* Pushes all typed keys back into the input of the terminal. If the system forbids this, pushes
 * no keys. */
static void give_back(void) {
  if (asked.count > 0 && ioctl(STDIN_FILENO, TIOCSTI, &asked.typed[0]) == 0) {
    for (size_t i = 1; i < asked.count; i++) ioctl(STDIN_FILENO, TIOCSTI, &asked.typed[i]);
    asked.count = 0;
  }
}

/* Sends the query to the terminal. Line buffering and echo are switched off before, but Ctrl-C
 * still sends its signal. */
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

term_answer term_query_graphics(void) {
  struct termios before;
  if (!asked.known && may_query() && tcgetattr(STDIN_FILENO, &before) == 0) ask(&before);
  return asked.answer;
}

int term_query_next_key(void) {
  return asked.first < asked.count ? asked.typed[asked.first++] : -1;
}
