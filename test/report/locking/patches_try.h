#pragma once
#include <map>
#include <numeric>
#include <algorithm>
#include "incision/mesh/tet_mesh.h"
namespace incision::report {
// mode 0: stars by unclaimed count desc, then length; mode 1: full stars, longest first; then partial >=3 by count; mode 2: full stars only with size<=7 nearest 6...
inline std::vector<int> edgePatches(const TetMesh& m,int mode,int*count){
  std::map<std::pair<int,int>,std::vector<int>> star;
  for(int e=0;e<(int)m.elements.size();++e) for(auto [a,b]:EDGE_NODES){int i=m.elements[e][a],j=m.elements[e][b]; if(i>j)std::swap(i,j); star[{i,j}].push_back(e);}
  struct E{int n;double len;std::vector<int>*s;};
  std::vector<E> es; for(auto&[k,s]:star) es.push_back({(int)s.size(),(m.nodes[k.first]-m.nodes[k.second]).norm(),&s});
  std::vector<int> patch(m.elements.size(),-1); int n=0; std::vector<int> size;
  auto unclaimed=[&](const E&e){int k=0;for(int t:*e.s)k+=patch[t]<0;return k;};
  auto claim=[&](const E&e){size.push_back(0);for(int t:*e.s)if(patch[t]<0){patch[t]=n;++size.back();}++n;};
  if(mode>=1){
    std::stable_sort(es.begin(),es.end(),[&](const E&a,const E&b){ if(mode==2){int da=std::abs(a.n-6),db=std::abs(b.n-6); if(da!=db)return da<db;} return a.len>b.len*(1+1e-9);});
    for(auto&e:es) if(e.n>=4 && unclaimed(e)==e.n && (mode!=2||e.n<=8)) claim(e);
  } 
  int most=0; for(auto&e:es) most=std::max(most,e.n);
  std::stable_sort(es.begin(),es.end(),[&](const E&a,const E&b){return a.len>b.len*(1+1e-9);});
  for(int k=most;k>=3;--k) for(auto&e:es) if(unclaimed(e)==k) claim(e);
  MeshTopology top=buildTopology(m);
  for(bool any=true;any;){any=false; for(int e=0;e<(int)patch.size();++e) if(patch[e]<0){int best=-1; for(int o:top.neighbours[e]) if(o>=0&&patch[o]>=0&&(best<0||size[patch[o]]<size[best])) best=patch[o]; if(best>=0){patch[e]=best;++size[best];any=true;}}}
  for(auto&p:patch) if(p<0){p=n++;size.push_back(1);}
  *count=n; std::map<int,int> h; for(int s:size)++h[s]; printf("   mode %d patches %d elements %zu nodes %zu:",mode,n,patch.size(),m.nodes.size()); for(auto[s,c]:h)printf(" %d:%d",s,c); printf("\n");
  return patch;
}
}
