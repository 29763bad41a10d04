/* Module `archard.random`: computes points in the unit cube for a design and a seed, and quantiles
 * and correlations for uncertainties. No other file uses GSL's generators, distributions and
 * statistics. The results depend only on the arguments: the same seed gives identical points. */
#include "lua/base/archard.h"
#include "lua/base/error.h"
#include "lua/base/args.h"
#include "lua/base/array_read.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics_double.h>
#include <lauxlib.h>
#include <stdlib.h>

enum { SOBOL_BITS = 30, SOBOL_MOST = 40 };

/* Points in the unit cube. Coordinate d of point i is column[d * count + i], in (0, 1). */
typedef struct points {
  double *column;
  size_t count, dimensions;
  gsl_rng *random;
} points;

/* --- designs ---------------------------------------------------------------------------------- */

static int fill_random(const points *p) {
  for (size_t i = 0; i < p->count; i++)
    for (size_t d = 0; d < p->dimensions; d++)
      p->column[d * p->count + i] = gsl_rng_uniform_pos(p->random);
  return 0;
}

/* Fills a Latin hypercube: each axis is divided into `count` intervals, and each interval
 * contains exactly one point, in random order. */
static int fill_latin(const points *p) {
  size_t *slice = malloc(p->count * sizeof *slice);
  if (!slice) return -1;
  for (size_t d = 0; d < p->dimensions; d++) {
    for (size_t i = 0; i < p->count; i++) slice[i] = i;
    gsl_ran_shuffle(p->random, slice, p->count, sizeof *slice);
    for (size_t i = 0; i < p->count; i++)
      p->column[d * p->count + i] =
          ((double)slice[i] + gsl_rng_uniform_pos(p->random)) / (double)p->count;
  }
  free(slice);
  return 0;
}

/* Computes Sobol points with a random digital shift (exclusive or) for each axis. The shift
 * preserves the uniformity of the set and makes the distribution of each point uniform. Half a cell
 * is added, so that no coordinate is 0. The first point (the origin) is included although GSL omits
 * it, because without it 2^m points would not be evenly distributed. */
static int fill_sobol(const points *p) {
  const double cells = (double)(1UL << SOBOL_BITS);
  unsigned long flip[SOBOL_MOST];
  double at[SOBOL_MOST] = {0};
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)p->dimensions);
  if (!sequence) return -1;
  for (size_t d = 0; d < p->dimensions; d++)
    flip[d] = gsl_rng_uniform_int(p->random, 1UL << SOBOL_BITS);
  for (size_t i = 0; i < p->count; i++) {
    if (i > 0) gsl_qrng_get(sequence, at);
    for (size_t d = 0; d < p->dimensions; d++) {
      const unsigned long cell = (unsigned long)(at[d] * cells) ^ flip[d];
      p->column[d * p->count + i] = ((double)cell + 0.5) / cells;
    }
  }
  gsl_qrng_free(sequence);
  return 0;
}

static const char *const designs[] = {"sobol", "latin", "random", NULL};
static int (*const fill[])(const points *) = {fill_sobol, fill_latin, fill_random};

static void push_columns(lua_State *L, const points *p) {
  lua_createtable(L, (int)p->dimensions, 0);
  for (size_t d = 0; d < p->dimensions; d++) {
    array_push(L, p->column + d * p->count, p->count);
    lua_rawseti(L, -2, (lua_Integer)d + 1);
  }
}

/* points(design, count, dimensions, seed) returns a list of `dimensions` lists of `count`
 * numbers. */
static int random_points(lua_State *L) {
  static const char where[] = "random.points";
  const int design = args_choice(L, 1, (args_location){where, ""}, "design", designs, -1);
  const lua_Integer count = luaL_checkinteger(L, 2), dimensions = luaL_checkinteger(L, 3);
  const lua_Integer seed = luaL_checkinteger(L, 4);
  luaL_argcheck(L, count >= 1 && count <= 10000000, 2, "expected 1 to 10000000");
  luaL_argcheck(L, dimensions >= 1 && dimensions <= SOBOL_MOST, 3, "expected 1 to 40");
  points p = {array_buffer(L, (size_t)(count * dimensions)), (size_t)count, (size_t)dimensions,
              gsl_rng_alloc(gsl_rng_mt19937)};
  if (!p.random) error_raise(L, ARC_MEMORY, where, "out of memory");
  gsl_rng_set(p.random, (unsigned long)seed);
  const int failed = fill[design](&p);
  gsl_rng_free(p.random);
  if (failed) error_raise(L, ARC_MEMORY, where, "out of memory");
  push_columns(L, &p);
  return 1;
}

/* --- distributions ---------------------------------------------------------------------------- */

/* normal_quantile(p) returns the quantile of the standard normal distribution. */
static int normal_quantile(lua_State *L) {
  lua_pushnumber(L, gsl_cdf_ugaussian_Pinv(luaL_checknumber(L, 1)));
  return 1;
}

/* normal_share(z) returns the cumulative probability of the standard normal distribution. */
static int normal_share(lua_State *L) {
  lua_pushnumber(L, gsl_cdf_ugaussian_P(luaL_checknumber(L, 1)));
  return 1;
}

/* beta_quantile(p, a, b) returns the quantile of the beta distribution. */
static int beta_quantile(lua_State *L) {
  lua_pushnumber(
      L, gsl_cdf_beta_Pinv(luaL_checknumber(L, 1), luaL_checknumber(L, 2), luaL_checknumber(L, 3)));
  return 1;
}

/* student_quantile(p, freedom) returns the quantile of Student's t distribution with `freedom`
 * degrees of freedom. */
static int student_quantile(lua_State *L) {
  lua_pushnumber(L, gsl_cdf_tdist_Pinv(luaL_checknumber(L, 1), luaL_checknumber(L, 2)));
  return 1;
}

/* rank_correlation(a, b) returns Spearman's rank correlation coefficient of two lists of equal
 * length, or NaN if a list is constant. */
static int rank_correlation(lua_State *L) {
  const args_location location = {"random.rank_correlation", ""};
  size_t count = 0, other = 0;
  lua_settop(L, 2);
  const double *b = array_read(L, location, "b", &count);
  lua_pushvalue(L, 1);
  const double *a = array_read(L, location, "a", &other);
  luaL_argcheck(L, other == count, 2, "expected a list as long as the first list");
  lua_pushnumber(L, gsl_stats_spearman(a, 1, b, 1, count, array_buffer(L, 2 * count)));
  return 1;
}

int luaopen_archard_random(lua_State *L) {
  static const luaL_Reg functions[] = {{"points", random_points},
                                       {"normal_quantile", normal_quantile},
                                       {"normal_share", normal_share},
                                       {"beta_quantile", beta_quantile},
                                       {"student_quantile", student_quantile},
                                       {"rank_correlation", rank_correlation},
                                       {NULL, NULL}};
  luaL_newlib(L, functions);
  lua_pushinteger(L, SOBOL_MOST);
  lua_setfield(L, -2, "most_dimensions");
  return 1;
}
