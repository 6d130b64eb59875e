#include <chrono>
#include <cstdio>
#include <fstream>
#include "incision/mesh/mesh_io.h"
#include <Eigen/SparseCholesky>
#include "report/locking/reference.h"
#include "report/locking/tissue.h"
#include "incision/solver/sparse_cholesky.h"
using namespace incision; using namespace incision::report;
using C=std::chrono::steady_clock;
double ms(C::time_point t){return 1e3*std::chrono::duration<double>(C::now()-t).count();}
struct Cost{double factor,solve; long nnz; int cg; double cgms;};
Vector direct(const Sparse&K,const Vector&f,Cost*c){
  LowerTriangle low; std::vector<double> v; low.column_start={0};
  for(int j=0;j<K.outerSize();++j){for(Sparse::InnerIterator it(K,j);it;++it) if(it.row()>=j){low.row.push_back(it.row());v.push_back(it.value());} low.column_start.push_back(low.row.size());}
  SparseCholesky ch; ch.analyse(low,3);
  auto t=C::now(); bool ok=ch.factorise(v); c->factor=ms(t); if(!ok) printf("NOT PD\n");
  std::vector<double> b(f.data(),f.data()+f.size()),x; t=C::now(); ch.solve(b,&x); c->solve=ms(t); c->nnz=v.size();
  return Eigen::Map<Vector>(x.data(),x.size());
}

TetMesh gm(const Problem&p,double h){
  std::ofstream o("/tmp/lk.geo"); o<<"SetFactory(\"OpenCASCADE\"); Box(1)={"<<p.origin.x()<<","<<p.origin.y()<<","<<p.origin.z()<<","<<p.size.x()<<","<<p.size.y()<<","<<p.size.z()<<"};\n";
  if(p.name=="pressed block") o<<"Rectangle(20)={-.25,-.25,.5,.5,.5}; BooleanFragments{Volume{1};Delete;}{Surface{20};Delete;}\n";
  o<<"Mesh.MeshSizeMin="<<h<<";Mesh.MeshSizeMax="<<h<<";\n"; o.close();
  if(system("gmsh -3 -format msh22 /tmp/lk.geo -o /tmp/lk.msh >/dev/null")) exit(3);
  return readGmsh("/tmp/lk.msh");
}
int main(int argc,char**argv){
  int nmax=argc>1?atoi(argv[1]):4; int un=argc>2?atoi(argv[2]):0;
  for (auto p : {cantilever(), heldBlock(), pressedBlock()}) for (double nu : {0.45,0.4999}) {
    double r=reference(p,nu,p.name=="cantilever"?32:16);
    printf("%s %g ref %.6g\n",p.name.c_str(),nu,r);
    for(int n=1;n<=nmax;n*=2){
      Specimen s(p,un?gm(p,(p.name=="cantilever"?.125:.25)*1.15/n):p.grid(n));
      for(double b:{0.,0.3}) for(int mode=-2;mode<3;++mode){ 
        if((mode==-2||(!un&&mode>0))&&b>0)continue;
        BASE_RATIO=b;MODE=mode; auto a=mode==-2?Averaging::NONE:mode==-1?Averaging::COPIES:Averaging::CELLS;
        Tissue t=s.tissue(nu,a); Cost c; Sparse K=t.matrix(); Vector u=direct(K,t.f,&c);
        printf("  n=%d dof %d base %g avg %d mode %d err %+.2f%% dil %.3g nnz %ld factor %.1f solve %.1f ms\n",n,s.freedoms(),b,(int)a,mode,100*(s.answer(t,u)/r-1),s.dilatation(u),c.nnz,c.factor,c.solve); fflush(stdout);
      }
    }
  }
}
