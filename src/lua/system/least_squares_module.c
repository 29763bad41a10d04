/* Module `archard.least_squares`: nonlinear least squares (Levenberg-Marquardt with a trust
 * region) and singular values, for scripts/fit. No other file uses GSL's fits. GSL calls Lua
 * functions through this module. Each call is protected, and an error is raised again only after
 * GSL has returned and its memory is freed. */
#include "lua/base/archard.h"
#include "lua/base/array_read.h"
#include "lua/base/error.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <lauxlib.h>

static const char where[] = "fit";

static arc_setting row(const char *name, double low) {
  return (arc_setting){.name = name, .low = low, .high = 1e9};
}

static double number_field(lua_State *L, int table, const char *name, double low) {
  const arc_setting setting = row(name, low);
  lua_getfield(L, table, name);
  const double value = args_number(L, (args_location){where, ""}, &setting);
  lua_pop(L, 1);
  return value;
}

/* --- nonlinear least squares ------------------------------------------------------------------ */

enum { PROBLEM = 1 }; /* stack index of the table that describes the problem */

typedef struct callback {
  lua_State *L;
  const char *name; /* name of the function in the problem's table */
  const gsl_vector *x;
  double *to;
  size_t count; /* length of the list that the function must return */
  int failed;   /* true if the call failed; the error value is on top of the stack */
} callback;

/* Calls the user's function with a list and copies the returned list. Runs inside lua_pcall. */
static int call_protected(lua_State *L) {
  callback *call = lua_touserdata(L, 2);
  lua_getfield(L, PROBLEM, call->name);
  array_push(L, call->x->data, call->x->size);
  lua_call(L, 1, 1);
  size_t count = 0;
  const double *values = array_read(L, (args_location){where, ""}, call->name, &count);
  if (count != call->count)
    return luaL_error(L, "%s: %d numbers expected, got %d", call->name, (int)call->count,
                      (int)count);
  for (size_t i = 0; i < count; i++) call->to[i] = values[i];
  return 0;
}

static int evaluate(callback *call, const char *name, const gsl_vector *x, double *to,
                    size_t count) {
  if (call->failed) return GSL_EBADFUNC;
  call->name = name;
  call->x = x;
  call->to = to;
  call->count = count;
  lua_State *L = call->L;
  lua_pushcfunction(L, call_protected);
  lua_pushvalue(L, PROBLEM);
  lua_pushlightuserdata(L, call);
  call->failed = lua_pcall(L, 2, 0, 0) != LUA_OK;
  return call->failed ? GSL_EBADFUNC : GSL_SUCCESS;
}

/* Computes the residuals. The memory of `f` is used as an array, because GSL allocates the vectors
 * and matrices of this solver without gaps. */
static int residuals(const gsl_vector *x, void *context, gsl_vector *f) {
  return evaluate(context, "residuals", x, f->data, f->size);
}

static int jacobian(const gsl_vector *x, void *context, gsl_matrix *j) {
  return evaluate(context, "jacobian", x, j->data, j->size1 * j->size2);
}

typedef struct outcome {
  int status, info;
  size_t iterations;
} outcome;

static outcome minimise(gsl_multifit_nlinear_workspace *work, gsl_multifit_nlinear_fdf *fdf,
                        const double *start, size_t most, double tolerance) {
  outcome end = {0};
  const gsl_vector_const_view x = gsl_vector_const_view_array(start, fdf->p);
  end.status = gsl_multifit_nlinear_init(&x.vector, fdf, work);
  if (end.status == GSL_SUCCESS)
    end.status = gsl_multifit_nlinear_driver(most, tolerance, 1e-8, 0, NULL, NULL, &end.info, work);
  end.iterations = gsl_multifit_nlinear_niter(work);
  return end;
}

/* solve{ x=, count=, residuals=, jacobian=, iterations=, tolerance= } returns x, the number of
 * iterations, and the reason for the end: "step" (the last step was small), "gradient", or GSL's
 * message if the search failed. residuals(x) must return a list of `count` numbers, jacobian(x) a
 * flat list of count * #x numbers, row by row. */
static int solve(lua_State *L) {
  luaL_checktype(L, PROBLEM, LUA_TTABLE);
  lua_settop(L, PROBLEM);
  callback call = {.L = L};
  const size_t count = (size_t)number_field(L, PROBLEM, "count", 1);
  const size_t most = (size_t)number_field(L, PROBLEM, "iterations", 1);
  const double tolerance = number_field(L, PROBLEM, "tolerance", 0);
  size_t unknowns = 0;
  lua_getfield(L, PROBLEM, "x");
  double *x = array_read(L, (args_location){where, ""}, "x", &unknowns);
  if (unknowns == 0 || count < unknowns) return luaL_error(L, "too few data");
  gsl_multifit_nlinear_fdf fdf = {
      .f = residuals, .df = jacobian, .n = count, .p = unknowns, .params = &call};
  const gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_workspace *work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, count, unknowns);
  if (!work) error_raise(L, ARC_MEMORY, where, "out of memory");
  const outcome end = minimise(work, &fdf, x, most, tolerance);
  for (size_t i = 0; i < unknowns; i++) x[i] = gsl_vector_get(work->x, i);
  gsl_multifit_nlinear_free(work);
  if (call.failed) return lua_error(L);
  array_push(L, x, unknowns);
  lua_pushinteger(L, (lua_Integer)end.iterations);
  lua_pushstring(L, end.status ? gsl_strerror(end.status) : end.info == 1 ? "step" : "gradient");
  return 3;
}

/* --- singular values -------------------------------------------------------------------------- */

/* svd{ a=, rows=, columns= } returns u, s and v with a = u diag(s) v', each as a flat list, row by
 * row. `rows` must be at least `columns`. The method is one-sided Jacobi, so that small singular
 * values are as accurate as large ones. */
static int svd(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  const size_t rows = (size_t)number_field(L, 1, "rows", 1);
  const size_t columns = (size_t)number_field(L, 1, "columns", 1);
  size_t count = 0;
  lua_getfield(L, 1, "a");
  double *a = array_read(L, (args_location){where, ""}, "a", &count);
  if (count != rows * columns || rows < columns)
    return luaL_error(L, "svd: expected rows >= columns and a list of rows * columns numbers");
  double *s = array_buffer(L, columns), *v = array_buffer(L, columns * columns);
  gsl_matrix_view of_a = gsl_matrix_view_array(a, rows, columns);
  gsl_matrix_view of_v = gsl_matrix_view_array(v, columns, columns);
  gsl_vector_view of_s = gsl_vector_view_array(s, columns);
  const int status = gsl_linalg_SV_decomp_jacobi(&of_a.matrix, &of_v.matrix, &of_s.vector);
  if (status) error_raise(L, ARC_NUMERIC, where, "singular values: %s", gsl_strerror(status));
  array_push(L, a, count);
  array_push(L, s, columns);
  array_push(L, v, columns * columns);
  return 3;
}

int luaopen_archard_least_squares(lua_State *L) {
  static const luaL_Reg functions[] = {{"solve", solve}, {"svd", svd}, {NULL, NULL}};
  gsl_set_error_handler_off(); /* without this call GSL would abort instead of returning a status */
  luaL_newlib(L, functions);
  return 1;
}
